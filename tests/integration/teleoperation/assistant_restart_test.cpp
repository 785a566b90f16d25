// The coordinator and the assistant are started again together, with their process: neither knows
// what was pressed before, but the arms do know that they have been used.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <memory>
#include <string>

#include "assistant/assistant.h"
#include "console/system_console.h"
#include "coordinator/coordinator.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// This person is at the robot.
struct Nurse final : suture::Device {
  suture::Required<EmergencyStop> button{*this, "Stop"};
};

/// This is one start of the desk's process.
struct Desk {
  explicit Desk(const std::string& names) : manager("desk", names) {
    manager.add("Coordinator", coordinator);
    manager.add("Assistant", assistant);
    manager.start();
    manager.connect("Assistant/Stop", "Coordinator/Stop");
  }
  ~Desk() { manager.stop(); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  Coordinator coordinator{CoordinatorParameters{}};
  Assistant assistant{AssistantParameters{}};
  suture::Manager manager;
};

/// The desk has the coordinator and the assistant; the robot has the arms, what moves them, and
/// their console.
class RestartedDesk : public testing::TestWithParam<suture::Lane> {
 protected:
  RestartedDesk() {
    robot_.add("Console", console_);
    robot_.add("Teleop", teleop_);
    robot_.add("Nurse", nurse_);
    master_.addTo(robot_, "MTM");
    slave_.addTo(robot_, "PSM");
    robot_.start();
    startDesk();
    robot_.connect("Teleop/Master", "MTM/Arm");
    robot_.connect("Teleop/Slave", "PSM/Arm");
    robot_.connect("Console/MTML", "MTM/Arm");
    robot_.connect("Console/TeleopL", "Teleop/Teleoperation");
    for (const char* const one : {"MTMDrives", "PSMDrives", "Console", "Nurse"}) {
      robot_.connect(one + std::string("/Stop"), "desk:Coordinator/Stop", options());
    }
  }
  ~RestartedDesk() override {
    desk_.reset();
    robot_.stop();
  }

  suture::ConnectOptions options() const {
    return {.lane = GetParam(), .contract = {.silence = 500ms}};
  }
  void startDesk() {
    desksProcess_.run([this] {
      desk_ = std::make_unique<Desk>(names_.address());
      desk_->manager.connect("Assistant/Console", "robot:Console/Console", options());
      desk_->manager.connect("Assistant/Left", "robot:Teleop/Teleoperation", options());
    });
  }
  void restartDesk() {
    desk_.reset();
    pass(3s);  // all hear of it
    startDesk();
    pass(10s);  // all are connected again
  }
  /// The console learns of all parts of its system only by this.
  void completeSystem() { robot_.connect("Console/PSM2", "PSM/Arm"); }
  bool mayHavePower() const { return desk_->coordinator.permit().granted; }
  bool isUp() const { return console_.console_state() == ConsoleState::Up; }
  template <class Condition>
  static bool until(const Condition& condition) {
    return suture::clockOfTest().until(condition);
  }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process desksProcess_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm master_{Side::Left, 30ms};
  DrivenPsm slave_{30ms};
  Teleop teleop_{{.enable_at_start = false}};
  Nurse nurse_;
  SystemConsole console_{{.system = {"MTML", "PSM2", "TeleopL"}, .bring_up_by_itself = true}};
  suture::Manager robot_{"robot", names_.address()};
  std::unique_ptr<Desk> desk_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, RestartedDesk,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(RestartedDesk, KeepsWhatWasPressedBefore) {
  completeSystem();
  ASSERT_TRUE(until([this] { return isUp(); })) << "the assistant releases the stop of the start";
  ASSERT_TRUE(nurse_.button.press());
  pass(100ms);
  ASSERT_FALSE(mayHavePower());
  restartDesk();
  EXPECT_FALSE(mayHavePower());
  const auto released = nurse_.button.release(desk_->coordinator.permit().press);
  ASSERT_TRUE(released) << suture::toString(released.error());
  pass(100ms);
  EXPECT_TRUE(mayHavePower()) << "a person may release it";
}

TEST_P(RestartedDesk, AwaitsNewsOfAllArms) {
  pass(10s);
  EXPECT_FALSE(mayHavePower()) << "an arm that says nothing may have been used";
  completeSystem();
  EXPECT_TRUE(until([this] { return mayHavePower(); }));
}

}  // namespace
}  // namespace robots::test
