// These test the jaw of a slave and the gripper of a master, in one process and over each lane.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <string>
#include <vector>

#include "arm/arm_warning.h"
#include "drives/coupling.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// Fingers are a surgeon's hand, which teleoperates the instrument.
struct Fingers final : suture::Device {
  Fingers() {
    gripper.on().closed([this](const bool& is) { closed.push_back(is); });
    jaw.on().warning([this](const suture::Message& said) {
      warnings.push_back(static_cast<ArmWarning>(said.code));
    });
    jaw.on().goal_reached([this](const bool& reached) { goals.push_back(reached); });
  }
  suture::Required<GripperHand> hand{*this, "Hand"};
  suture::Required<Gripper> gripper{*this, "Gripper"};
  suture::Required<Arm> slave{*this, "Slave"};
  suture::Required<Jaw> jaw{*this, "Jaw"};
  std::vector<bool> closed, goals;
  std::vector<ArmWarning> warnings;
};

/// The robot has both arms, the fingers are elsewhere; on Lane::Auto all are one process.
class Tool : public testing::TestWithParam<suture::Lane> {
 protected:
  Tool() {
    master_.addTo(robot_, "MTM");
    slave_.addTo(robot_, "PSM");
    client().add("Fingers", fingers_);
    robot_.start();
    if (!isOneProcess()) elsewhere_.start();
    connect("Hand", "MTMDrives/Hand");
    connect("Gripper", "MTM/Gripper");
    connect("Slave", "PSM/Arm");
    connect("Jaw", "PSM/Jaw");
    EXPECT_TRUE(becomes(ArmState::Disabled));
  }
  ~Tool() override {
    elsewhere_.stop();
    robot_.stop();
  }

  bool becomes(ArmState wanted) {
    return suture::clockOfTest().until(
        [&] { return slave_.arm.operating_state().state == wanted; });
  }
  void enable() {
    EXPECT_TRUE(fingers_.slave.enable());
    EXPECT_TRUE(becomes(ArmState::Enabled));
  }
  void servoJaw(double angle, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      EXPECT_TRUE(fingers_.jaw.servo_jp({{angle}, suture::now()}));
      pass(1ms);
    }
  }
  double jaw() { return angle(fingers_.jaw.measured_js); }
  /// Returns where the jaw is by what the drives measure of their actuators.
  double turnedByDiscs() {
    const auto& discs = slave_.drives.feedback().position;
    return psmCoupling().joints(Coupling<7>::Vector::Map(discs.data()))[6];
  }
  double gripper() { return angle(fingers_.gripper.measured_js); }

  Fingers fingers_;

 private:
  /// Returns where that joint is. Rows are published of what a client has asked for.
  template <class Read>
  static double angle(Read& measured_js) {
    (void)measured_js();
    pass(10ms);
    const auto sample = measured_js();
    EXPECT_TRUE(sample && sample->valid);
    return sample->position.at(0);
  }
  static bool isOneProcess() { return GetParam() == suture::Lane::Auto; }
  suture::Manager& client() { return isOneProcess() ? robot_ : elsewhere_; }
  void connect(const std::string& required, const std::string& provided) {
    client().connect("Fingers/" + required, (isOneProcess() ? "" : "robot:") + provided,
                     {.lane = GetParam()});
  }

  const suture::TemporaryDirectory directory_;
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm master_;
  DrivenPsm slave_;
  suture::Manager robot_{"robot", names_.address()}, elsewhere_{"console", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, Tool,
                         testing::Values(suture::Lane::Auto, suture::Lane::Shm, suture::Lane::Frame,
                                         suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(Tool, ASqueezedGripperIsMeasured) {
  EXPECT_TRUE(fingers_.hand.squeeze(0.4));
  pass(300ms);
  EXPECT_NEAR(gripper(), 0.4, 1e-6);
  EXPECT_TRUE(fingers_.hand.squeeze(-0.1));
  pass(300ms);
  fingers_.processEvents();
  EXPECT_EQ(fingers_.closed, (std::vector{false, true}));
}

TEST_P(Tool, AJawGoesWhereItIsSent) {
  enable();
  servoJaw(0.8, 300);
  EXPECT_NEAR(jaw(), 0.8, 1e-6);
  EXPECT_NEAR(turnedByDiscs(), 0.8, 1e-6);
  EXPECT_TRUE(fingers_.jaw.move_jp({{-0.3}, suture::now()}));
  pass(2s);
  EXPECT_NEAR(jaw(), -0.3, 1e-6);
  fingers_.processEvents();
  EXPECT_EQ(fingers_.goals, std::vector{true});
  EXPECT_TRUE(fingers_.warnings.empty());
}

TEST_P(Tool, TheJawOfADisabledArmStays) {
  servoJaw(0.8, 50);
  EXPECT_EQ(jaw(), 0);
  fingers_.processEvents();
  EXPECT_EQ(fingers_.warnings, std::vector{ArmWarning::NotEnabled});
}

TEST_P(Tool, AJawStopsWithItsArm) {
  enable();
  servoJaw(0.4, 20);
  EXPECT_TRUE(fingers_.slave.disable());
  EXPECT_TRUE(becomes(ArmState::Disabled));
  pass(100ms);
  const double stopped = jaw();
  EXPECT_LT(stopped, 0.39);
  servoJaw(0.8, 50);
  EXPECT_EQ(jaw(), stopped);
}

}  // namespace
}  // namespace robots::test
