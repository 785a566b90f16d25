// A slot holds a value, or says that it cannot.
#include <gtest/gtest.h>
#include <suture/base/slots/slot_forms.h>

#include <chrono>
#include <cstdint>

namespace suture {
namespace {

using namespace std::chrono_literals;

template <class Duration>
bool fits(Duration value) {
  std::int64_t slot = 0;
  if (!store(value, slot)) return false;
  Duration back{};
  load(slot, back);
  EXPECT_EQ(back, value);
  return true;
}

TEST(SlotForms, RefuseADurationOfMoreNanosecondsThanFit) {
  EXPECT_FALSE(fits(std::chrono::milliseconds::max()));
  EXPECT_FALSE(fits(std::chrono::milliseconds::min()));
  EXPECT_FALSE(fits(std::chrono::hours(3'000'000)));
  EXPECT_FALSE(fits(std::chrono::duration<std::uint64_t>(1'000'000'000'000)));
  EXPECT_TRUE(fits(std::chrono::hours(2'000'000)));
  EXPECT_TRUE(fits(-1500ms));
  EXPECT_TRUE(fits(std::chrono::nanoseconds::max()));
  EXPECT_TRUE(fits(std::chrono::duration<std::int64_t, std::ratio<1, 30>>(300)));
}

}  // namespace
}  // namespace suture
