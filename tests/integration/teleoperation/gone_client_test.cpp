// An arm whose teleoperation is gone holds at once, and not only when the stream has been silent.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "arm/arm_warning.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "integration/teleoperation/scene/scripted_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// Hears what the arm warns of.
struct Panel final : suture::Device {
  Panel() {
    arm.on().warning([this](const suture::Message& said) {
      codes.push_back(static_cast<ArmWarning>(said.code));
    });
  }
  suture::Required<Arm> arm{*this, "Arm"};
  std::vector<ArmWarning> codes;
};

/// Holds the arm's process, and the console's with all that drives it.
class GoneConsole : public testing::TestWithParam<suture::Lane> {
 protected:
  static constexpr suture::Duration kSilence = 50ms;  // half of what ends a stream by itself

  GoneConsole() {
    psm_.addTo(robot_, "PSM");
    robot_.add("Panel", panel_);
    robot_.connect("Panel/Arm", "PSM/Arm");
    robot_.start();
    consolesProcess_.run([this] {
      console_ = std::make_unique<suture::Manager>("console", names_.address());
      console_->add("MTM", master_);
      console_->add("Teleop", teleop_);
      console_->start();
      console_->connect("Teleop/Master", "MTM/Arm");
      console_->connect("Teleop/Slave", "robot:PSM/Arm",
                        {.lane = GetParam(), .contract = {.silence = kSilence}});
    });
  }
  ~GoneConsole() override {
    if (console_ != nullptr) console_->stop();
    robot_.stop();
  }
  bool follows() {
    return suture::clockOfTest().until([&] { return activity() == "servo_cp"; });
  }
  std::string activity() { return psm_.arm.operating_state().sub_state; }
  void expectHolds() {
    EXPECT_EQ(activity(), "holding");
    panel_.processEvents();
    EXPECT_EQ(panel_.codes, std::vector{ArmWarning::ClientGone});
  }

  const suture::TemporaryDirectory directory_;
  suture::TestClock::Process consolesProcess_{suture::clockOfTest()};
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenPsm psm_;
  Panel panel_;
  ScriptedArm master_;
  Teleop teleop_{TeleopParameters{}};
  suture::Manager robot_{"robot", names_.address()};
  std::unique_ptr<suture::Manager> console_;
};

INSTANTIATE_TEST_SUITE_P(Lanes, GoneConsole,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(GoneConsole, ItsEndHoldsTheArmAtOnce) {
  ASSERT_TRUE(follows());
  console_->stop();
  console_.reset();
  pass(2ms);
  expectHolds();
}

TEST_P(GoneConsole, AStoppedOneHoldsAfterTheLease) {
  ASSERT_TRUE(follows());
  consolesProcess_.freeze();
  pass(kSilence + 2ms);
  expectHolds();
  consolesProcess_.thaw();
  EXPECT_TRUE(follows()) << "it comes back";
}

TEST(GoneTask, ADisconnectHoldsTheArmAtOnce) {
  DrivenPsm psm;
  ScriptedArm master;
  Teleop teleop{TeleopParameters{}};
  suture::Manager manager("workstation");
  psm.addTo(manager, "PSM");
  manager.add("MTM", master);
  manager.add("Teleop", teleop);
  manager.connect("Teleop/Master", "MTM/Arm");
  manager.connect("Teleop/Slave", "PSM/Arm");
  manager.start();
  const auto activity = [&] { return psm.arm.operating_state().sub_state; };
  EXPECT_TRUE(suture::clockOfTest().until([&] { return activity() == "servo_cp"; }));
  manager.disconnect("Teleop/Slave");
  pass(3ms);
  EXPECT_EQ(activity(), "holding");
  manager.stop();
}

}  // namespace
}  // namespace robots::test
