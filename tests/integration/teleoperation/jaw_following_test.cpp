// The slave's jaw follows the master's gripper, in one process and over each lane.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <atomic>
#include <chrono>
#include <string>

#include "integration/teleoperation/scene/driven_arm.h"
#include "integration/teleoperation/scene/followed_arms.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "teleop/teleop.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

/// A SqueezingSurgeon has the surgeon's fingers, and eyes for the jaw.
struct SqueezingSurgeon final : suture::Device {
  suture::Required<GripperHand> hand{*this, "Hand"};
  suture::Required<Jaw> jaw{*this, "Jaw"};
  suture::Required<Teleoperation> teleop{*this, "Teleoperation"};
};

/// The console has the master and the teleoperation, the robot the slave; on Lane::Auto both are
/// one process.
class JawFollowing : public testing::TestWithParam<suture::Lane> {
 protected:
  JawFollowing() {
    master_.addTo(console_, "MTM");
    console_.add("Teleop", teleop_);
    console_.add("Surgeon", surgeon_);
    console_.connect("Teleop/Master", "MTM/Arm");
    console_.connect("Teleop/Gripper", "MTM/Gripper");
    console_.connect("Surgeon/Hand", "MTMDrives/Hand");
    console_.connect("Surgeon/Teleoperation", "Teleop/Teleoperation");
    slave_.addTo(robot(), "PSM");
    console_.start();
    if (!isOneProcess()) elsewhere_.start();
    connect("Teleop/Slave", "PSM/Arm");
    connect("Teleop/Jaw", "PSM/Jaw");
    connect("Surgeon/Jaw", "PSM/Jaw");
  }
  ~JawFollowing() override {
    elsewhere_.stop();
    console_.stop();
  }

  void pauseTeleoperation() { console_.suspend("Teleop"); }
  void resumeTeleoperation() { console_.resume("Teleop"); }
  bool reaches(TeleopState state) {
    return suture::clockOfTest().until([&] {
      const auto now = surgeon_.teleop.teleop_state();
      return now && *now == state;
    });
  }
  double jaw() {
    (void)surgeon_.jaw.measured_js();  // only asked-for rows are published
    pass(10ms);
    const auto sample = surgeon_.jaw.measured_js();
    EXPECT_TRUE(sample && sample->valid);
    return sample->position.at(0);
  }

  SqueezingSurgeon surgeon_;

 private:
  static bool isOneProcess() { return GetParam() == suture::Lane::Auto; }
  suture::Manager& robot() { return isOneProcess() ? console_ : elsewhere_; }
  void connect(const std::string& required, const std::string& provided) {
    console_.connect(required, isOneProcess() ? provided : "robot:" + provided,
                     {.lane = GetParam()});
  }

  const suture::TemporaryDirectory directory_;
  suture::loop::ControlThread control_;
  suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  DrivenMtm master_;
  DrivenPsm slave_;
  Teleop teleop_{{.jaw_scale = 2}};
  suture::Manager console_{"console", names_.address()}, elsewhere_{"robot", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(Lanes, JawFollowing,
                         testing::Values(suture::Lane::Auto, suture::Lane::Shm, suture::Lane::Frame,
                                         suture::Lane::Rpc),
                         [](const auto& one) { return toString(one.param); });

TEST_P(JawFollowing, FollowsSlowlyAfterAnEntry) {
  ASSERT_TRUE(reaches(TeleopState::Following));
  ASSERT_TRUE(surgeon_.hand.squeeze(0.5));
  pass(3s);
  EXPECT_NEAR(jaw(), 1.0, 0.01);
  ASSERT_TRUE(surgeon_.hand.squeeze(0.4));
  pass(200ms);
  EXPECT_NEAR(jaw(), 0.8, 0.01) << "it has caught up, and is fast";

  ASSERT_TRUE(surgeon_.teleop.disable());
  ASSERT_TRUE(surgeon_.hand.squeeze(0.1));
  pass(500ms);
  EXPECT_NEAR(jaw(), 0.8, 0.01) << "it holds";
  ASSERT_TRUE(surgeon_.teleop.enable());
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(200ms);
  EXPECT_GT(jaw(), 0.6) << "the needle is dropped";
  EXPECT_LT(jaw(), 0.78);
  pass(1s);
  EXPECT_NEAR(jaw(), 0.2, 0.01);
}

TEST_P(JawFollowing, IsSlowAfterAPause) {
  ASSERT_TRUE(reaches(TeleopState::Following));
  ASSERT_TRUE(surgeon_.hand.squeeze(0.5));
  pass(3s);
  pauseTeleoperation();
  ASSERT_TRUE(surgeon_.hand.squeeze(0.1));
  pass(500ms);
  EXPECT_NEAR(jaw(), 1.0, 0.01) << "it holds";
  resumeTeleoperation();
  ASSERT_TRUE(reaches(TeleopState::Following));
  pass(200ms);
  EXPECT_GT(jaw(), 0.8) << "the needle is dropped";
  pass(2s);
  EXPECT_NEAR(jaw(), 0.2, 0.01);
}

/// Fingers are a gripper whose clock may be wrong, and the jaw that follows it.
struct Fingers final : suture::Device, Gripper, Jaw {
  const JointConfiguration& configuration_js() const override { return configuration_; }
  const JointState& measured_js() const override { return stamped(measured_, ahead); }
  const JointState& setpoint_js() const override { return stamped(setpoint_, 0ms); }
  void servo_jp(const JointGoal&) override { ++goals; }
  void servo_jf(const JointEffortGoal&) override {}
  void move_jp(const JointGoal&) override {}

  std::atomic<suture::Duration> ahead{0ms};
  std::atomic<int> goals = 0;

 private:
  static const JointState& stamped(JointState& state, suture::Duration ahead) {
    state.position.assign(1, 0);
    state.stamp = suture::now() + ahead;
    state.valid = true;
    return state;
  }

  JointConfiguration configuration_;
  mutable JointState measured_, setpoint_;
  suture::Provided<Gripper> gripper_{*this, "Gripper", *this};
  suture::Provided<Jaw> jaw_{*this, "Jaw", *this};
};

class FollowedJaw : public TeleopStates {
 protected:
  ~FollowedJaw() override { manager_.stop(); }

  void connectFingers() {
    manager_.add("Fingers", fingers_);
    manager_.start();
    manager_.connect("Teleop/Gripper", "Fingers/Gripper");
    manager_.connect("Teleop/Jaw", "Fingers/Jaw");
  }
  int goalsIn(suture::Duration time) {
    pass(5ms);
    fingers_.goals = 0;
    pass(time);
    return fingers_.goals;
  }

  Fingers fingers_;
};

TEST_F(FollowedJaw, AGripperOfTheFutureLeadsNothing) {
  startFollowing();
  connectFingers();
  EXPECT_GT(goalsIn(20ms), 0);
  fingers_.ahead = 1s;
  EXPECT_EQ(goalsIn(20ms), 0);
  fingers_.ahead = 0ms;
  EXPECT_GT(goalsIn(20ms), 0);
}

}  // namespace
}  // namespace robots::test
