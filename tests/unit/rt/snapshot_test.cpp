#include <gtest/gtest.h>
#include <suture/rt/snapshot.h>

#include <array>
#include <thread>

namespace suture::rt {
namespace {

using Words = std::array<std::uint64_t, 15>;

TEST(Snapshot, HoldsItsDefaultUntilItIsWritten) {
  Snapshot<Words> snapshot;
  EXPECT_EQ(snapshot.read(), Words{});
}

TEST(Snapshot, NeverTornUnderAFastWriter) {
  constexpr std::uint64_t kLast = 100'000;
  Snapshot<Words> snapshot;
  std::thread writer([&snapshot] {
    Words words{};
    for (std::uint64_t i = 1; i <= kLast; ++i) {
      words.fill(i);
      snapshot.write(words);
    }
  });
  for (std::uint64_t last = 0; last < kLast;) {
    const Words words = snapshot.read();
    for (const std::uint64_t word : words) ASSERT_EQ(word, words[0]);
    ASSERT_GE(words[0], last);
    last = words[0];
  }
  writer.join();
}

}  // namespace
}  // namespace suture::rt
