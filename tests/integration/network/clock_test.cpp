// The steady clock of this provider is not the client's: it is in a time namespace of its own.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <tuple>

#include "integration/network/console.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

class ClockTest : public testing::TestWithParam<std::tuple<Duration, Lane>> {
 protected:
  ClockTest() : names_(control_, "unix:" + directory_.file("m.sock")) {}

  std::unique_ptr<Child> hostAhead(std::chrono::seconds ahead,
                                   const char* program = paths::kArmHost,
                                   const std::function<void()>& prepare = {}) {
    auto child = std::make_unique<Child>(
        std::vector<std::string>{"/usr/bin/unshare", "--time", "--monotonic",
                                 std::to_string(ahead.count()), "--fork", "--kill-child", program,
                                 names_.address(), "skewed"},
        prepare);
    EXPECT_EQ(child->line(), "ready");
    return child;
  }

  TemporaryDirectory directory_;
  loop::ControlThread control_;
  GlobalManager names_;
};

TEST_P(ClockTest, AgesAreRightWithinTheShownError) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give a process another clock";
  const auto ahead = std::chrono::duration_cast<std::chrono::seconds>(std::get<0>(GetParam()));
  const Lane lane = std::get<1>(GetParam());
  const auto host = hostAhead(ahead);
  Console console;
  Manager manager("console", names_.address());
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "skewed:PSM/Arm", {.lane = lane});

  const auto channel = manager.channels().at(0);
  EXPECT_EQ(channel->lane, lane == Lane::Rpc ? "rpc" : "frame");
  EXPECT_EQ(channel->terms.laneReason,
            lane == Lane::Auto ? "the two processes have different clocks" : "");
  const Duration error = channel->clockError(), wrong = channel->clockShift() + ahead;
  EXPECT_GT(error, Duration{0});
  EXPECT_LT(error, 100ms);
  EXPECT_LE(std::max(wrong, -wrong), error + 2ns);  // halving loses up to 2 ns

  // Its ttl is 500 ms; and its stamp comes back as it went.
  const auto pose = poseAt(2);
  ASSERT_TRUE(console.arm.servo_cp.start(pose).within(kPatience));
  ASSERT_TRUE(eventually([&] {
    const auto read = console.arm.measured_cp();
    return read && read->pose.translation().x() == 2;
  }));
  const Time before = now();
  const auto read = console.arm.measured_cp();
  const Duration changed = read->stamp - pose.stamp;  // if the clocks were compared meanwhile
  EXPECT_LE(std::max(changed, -changed), error);
  EXPECT_GE(read.age(), Duration{0});
  EXPECT_LE(read.age(), now() - pose.stamp + error) << "asked at " << toNanoseconds(before);
  EXPECT_EQ(host->end(SIGKILL), -SIGKILL);
}

/// DriftTest has a clock that falls behind by 100 us in each second.
class DriftTest : public ClockTest {};

TEST_P(DriftTest, AClockThatFallsBehindIsFollowed) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give a process another clock";
  const auto lane = std::get<1>(GetParam());
  const auto ahead = std::chrono::duration_cast<std::chrono::seconds>(std::get<0>(GetParam()));
  const Time begin = now();
  const auto host = hostAhead(ahead, paths::kDriftingHost, [&] {
    setenv("DRIFT_FROM", std::to_string(toNanoseconds(begin + ahead)).c_str(), 1);
  });
  Console console;
  Manager manager("console", names_.address());
  manager.add("Console", console);
  manager.start();
  manager.connect("Console/Arm", "skewed:PSM/Arm", {.lane = lane});

  const auto channel = manager.channels().at(0);
  const Duration first = channel->clockShift();
  ASSERT_TRUE(eventually([&] {
    const Duration error = channel->clockError(), shift = channel->clockShift();
    const Duration wrong = shift + ahead - (now() - begin) / 10'000;
    if (shift == channel->clockShift()) {  // the shift has not changed meanwhile
      EXPECT_LE(std::max(wrong, -wrong), std::max(error, channel->clockError()) + 1us);
    }
    return shift - first > 300us;
  })) << "after three seconds it must be seen";
  EXPECT_TRUE(reaches(console, 2));
  EXPECT_EQ(host->end(SIGKILL), -SIGKILL);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Duration, Lane>>& info) {
  const auto [skew, lane] = info.param;
  return std::string(skew > Duration{0} ? "Ahead" : "Behind") + (lane == Lane::Auto    ? "OnAuto"
                                                                 : lane == Lane::Frame ? "OnFrame"
                                                                                       : "OnRpc");
}

INSTANTIATE_TEST_SUITE_P(Drifts, DriftTest,
                         testing::Combine(testing::Values(Duration(5000s)),
                                          testing::Values(Lane::Frame, Lane::Rpc)),
                         nameOf);

INSTANTIATE_TEST_SUITE_P(Skews, ClockTest,
                         testing::Combine(testing::Values(Duration(5000s), Duration(-60s)),
                                          testing::Values(Lane::Auto, Lane::Frame, Lane::Rpc)),
                         nameOf);

}  // namespace
}  // namespace suture
