// A recorded run of the whole chain obeys the law, in one process and over each lane, also late.

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <tuple>

#include "integration/teleoperation/scene/two_workstations.h"
#include "recorder/judge.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "timing/seconds.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

class Law : public testing::TestWithParam<std::tuple<suture::Lane, suture::Duration>> {
 protected:
  TwoWorkstations stations_{std::get<suture::Lane>(GetParam()),
                            std::get<suture::Duration>(GetParam())};
};

std::string nameOf(const testing::TestParamInfo<Law::ParamType>& one) {
  const auto& [lane, delay] = one.param;
  return toString(lane) + "_" + std::to_string(delay / 1ms) + "ms";
}

INSTANTIATE_TEST_SUITE_P(Lanes, Law,
                         testing::Combine(testing::Values(suture::Lane::Auto, suture::Lane::Shm,
                                                          suture::Lane::Frame, suture::Lane::Rpc),
                                          testing::Values(0ms)),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Delays, Law,
                         testing::Combine(testing::Values(suture::Lane::Auto),
                                          testing::Values(50ms, 200ms)),
                         nameOf);

TEST_P(Law, HoldsForARecordedRun) {
  suture::pass(4s);
  stations_.stop();
  EXPECT_EQ(stations_.slaveRecorder().dropped(), 0u);
  const Recording slave = stations_.slave();
  const PsmDrivesParameters drives;
  const Judgement judgement =
      judge(stations_.master().arm, slave.followed, slave.arm,
            {.time_constant = drives.time_constant, .delay = inSeconds(drives.period)});
  for (const std::string& violation : violations(judgement)) ADD_FAILURE() << violation;
  EXPECT_GT(judgement.compared, 2400u);
  EXPECT_GT(judgement.equal_time.mean, 0.0005) << "it cannot be in two places at once";
  EXPECT_NEAR(judgement.equal_time.mean, judgement.speed_times_latency,
              0.1 * judgement.speed_times_latency);
}

}  // namespace
}  // namespace robots::test
