#include <gtest/gtest.h>
#include <suture/wire/stamps.h>

#include <limits>

namespace suture::rpc {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();

TEST(Stamps, MovesAStampAndLeavesAnUnsetOne) {
  EXPECT_EQ(shifted(5, 3ns), 8);
  EXPECT_EQ(shifted(5, -7ns), -2);
  EXPECT_EQ(shifted(0, 3ns), 0);
}

TEST(Stamps, AStampFromNowhereStillHasAnAge) {
  EXPECT_EQ(shifted(kMost, 168h), kMost / 2);
  EXPECT_EQ(shifted(kLeast, -168h), -(kMost / 2));
  EXPECT_EQ(shifted(kMost, Duration::max()), kMost / 2);
  EXPECT_GT(now() - fromNanoseconds(shifted(kLeast, 0ns)), 0ns);
  EXPECT_LT(now() - fromNanoseconds(shifted(kMost, 0ns)), 0ns);
}

}  // namespace
}  // namespace suture::rpc
