// A recorded run of the whole chain obeys the law, in one process and over each lane, also late.

#include <gtest/gtest.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/transport/rpc/control_thread.h>

#include <chrono>
#include <string>
#include <tuple>

#include "integration/teleoperation/driven_arm.h"
#include "recorder/judge.h"
#include "recorder/recorder.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "surgeon/surgeon.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;

/// The console has the master, its surgeon and the teleoperation, the robot has the slave; each
/// has a recorder. On Lane::Auto both are one process. What the master tells takes so much longer.
class Law : public testing::TestWithParam<std::tuple<suture::Lane, suture::Duration>> {
 protected:
  Law() {
    master_.addTo(console_, "MTM");
    console_.add("Surgeon", surgeon_);
    console_.add("Teleop", teleop_);
    console_.add("MasterRecorder", masterRecorder_);
    console_.connect("Surgeon/Master", "MTM/Arm");
    console_.connect("Surgeon/Teleoperation", "Teleop/Teleoperation");
    console_.connect("Teleop/Master", "MTM/Arm", suture::Lane::Auto,
                     suture::Manager::kDefaultPatience, {.answers = delay()});
    console_.connect("MasterRecorder/Arm", "MTM/Arm");
    slave_.addTo(robot(), "PSM");
    robot().add("SlaveRecorder", slaveRecorder_);
    robot().connect("SlaveRecorder/Arm", "PSM/Arm");
    console_.start();
    if (!isOneProcess()) elsewhere_.start();
    connect(console_, "Teleop/Slave", isOneProcess() ? "PSM/Arm" : "robot:PSM/Arm");
    connect(robot(), "SlaveRecorder/Teleoperation",
            isOneProcess() ? "Teleop/Teleoperation" : "console:Teleop/Teleoperation");
  }
  ~Law() override { stop(); }

  void stop() {
    elsewhere_.stop();
    console_.stop();
  }
  std::string masterFile() const { return directory_.file("master.jsonl"); }
  std::string slaveFile() const { return directory_.file("slave.jsonl"); }

  Recorder& slaveRecorder() { return slaveRecorder_; }

 private:
  static suture::Lane lane() { return std::get<suture::Lane>(GetParam()); }
  static suture::Duration delay() { return std::get<suture::Duration>(GetParam()); }
  static bool isOneProcess() { return lane() == suture::Lane::Auto; }
  suture::Manager& robot() { return isOneProcess() ? console_ : elsewhere_; }
  static void connect(suture::Manager& client, const std::string& required,
                      const std::string& provided) {
    client.connect(required, provided, lane());
  }

  const suture::TemporaryDirectory directory_;
  suture::rpc::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm master_;
  DrivenPsm slave_;
  Surgeon surgeon_{SurgeonParameters{}};
  Teleop teleop_{{.scale = 0.4, .max_age = 20ms + delay()}};
  Recorder masterRecorder_{{.file = masterFile()}}, slaveRecorder_{{.file = slaveFile()}};
  suture::Manager console_{"console", names_.address()}, elsewhere_{"robot", names_.address()};
};

std::string nameOf(const testing::TestParamInfo<Law::ParamType>& one) {
  const auto& [lane, delay] = one.param;
  return std::string(toString(lane)) + "_" + std::to_string(delay / 1ms) + "ms";
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
  stop();
  EXPECT_EQ(slaveRecorder().dropped(), 0u);
  const Recording slave = readRecording(slaveFile());
  const Judgement judgement = judge(readRecording(masterFile()).arm, slave.followed, slave.arm,
                                    PsmDrivesParameters{}.time_constant);
  for (const std::string& violation : violations(judgement)) ADD_FAILURE() << violation;
  EXPECT_GT(judgement.compared, 2400u);
  EXPECT_GT(judgement.equal_time.mean, 0.0005) << "it cannot be in two places at once";
  EXPECT_NEAR(judgement.equal_time.mean, judgement.speed_times_latency,
              0.1 * judgement.speed_times_latency);
}

}  // namespace
}  // namespace robots::test
