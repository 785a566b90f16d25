// These tests call an arm directly. They check when it is ready, how it moves, what it refuses and
// what it announces.

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <vector>

#include "arm_control/crtk_arm.h"
#include "kinematics/pose_error.h"
#include "unit/arm/deaf.h"
#include "unit/arm/psm_model.h"
#include "unit/arm/trailing_joints.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Joints = ArmModel<6>::Joints;

struct Heard : Deaf {
  std::vector<OperatingState> states;
  std::vector<bool> goals;
  std::vector<ArmWarning> warnings;

  void operating_state(const OperatingState& state) { states.push_back(state); }
  void goal_reached(bool reached) { goals.push_back(reached); }
  void warning(const suture::Message& warning) {
    warnings.push_back(static_cast<ArmWarning>(warning.code));
  }
};

class ArmControllerTest : public testing::Test {
 protected:
  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      time_ += 1ms;
      joints_.step(controller_, time_);
      arm_.announce(heard_);
    }
  }
  void makeReady() {
    cycles(1);
    arm_.enable();
    arm_.home();
    while (!arm_.operating_state().is_homed) cycles(1);
    cycles(200);
    heard_ = {};
  }
  PoseStamped goalAt(const Eigen::Vector3d& offset) const {
    PoseStamped goal = arm_.setpoint_cp();
    goal.pose.translation() += offset;
    goal.stamp = suture::fromNanoseconds(42);
    return goal;
  }
  static JointGoal toGoal(const Joints& q) {
    return {{q.data(), q.data() + q.size()}, suture::fromNanoseconds(43)};
  }
  Joints measured() const { return Joints::Map(arm_.measured_js().position.data()); }

  suture::Time time_ = suture::fromNanoseconds(1'000'000'000);
  ArmController<6> controller_{psmModel()};
  CrtkArm<6> arm_{controller_};
  TrailingJoints<6> joints_{psmModel(), psmParked()};
  Heard heard_;
};

TEST_F(ArmControllerTest, StartsDisabledParkedAndSaysSo) {
  cycles(1);
  ASSERT_EQ(heard_.states.size(), 1u);
  EXPECT_EQ(heard_.states[0].state, ArmState::Disabled);
  EXPECT_FALSE(heard_.states[0].is_homed);
  EXPECT_TRUE(measured().isApprox(psmParked()));
  EXPECT_EQ(arm_.measured_cp().stamp, time_);
  EXPECT_TRUE(arm_.measured_cp().valid);
}

TEST_F(ArmControllerTest, AServoStreamEndsAsHold) {
  makeReady();
  const auto follow = [&](const char* activity, const auto& servo) {
    for (int i = 0; i < 20; ++i) {
      servo();
      cycles(1);
    }
    cycles(90);
    EXPECT_EQ(arm_.operating_state().sub_state, activity);
    const Joints before = Joints::Map(arm_.setpoint_js().position.data());
    heard_ = {};
    cycles(200);
    EXPECT_EQ(arm_.operating_state().sub_state, "holding") << "after " << activity;
    EXPECT_EQ(heard_.states.size(), 1u) << "it is told once";
    EXPECT_EQ(Joints(Joints::Map(arm_.setpoint_js().position.data())), before);
  };
  const PoseStamped pose = goalAt({0.001, 0, 0});
  follow("servo_cp", [&] { arm_.servo_cp(pose); });
  const JointGoal joints = toGoal(Joints::Map(arm_.setpoint_js().position.data()));
  follow("servo_jp", [&] { arm_.servo_jp(joints); });
}

TEST_F(ArmControllerTest, AServoSilenceEndsNoLaterMove) {
  makeReady();
  arm_.servo_cp(goalAt({0.001, 0, 0}));
  cycles(1);
  Joints far = psmModel().home;
  far[0] += 0.5;
  arm_.move_jp(toGoal(far));
  cycles(150);
  EXPECT_EQ(arm_.operating_state().sub_state, "moving");
}

TEST_F(ArmControllerTest, IgnoresMotionUntilEnabledAndWarnsOnce) {
  cycles(1);
  for (int i = 0; i < 5; ++i) {
    arm_.servo_cp(goalAt({0.01, 0, 0}));
    cycles(1);
  }
  EXPECT_EQ(heard_.warnings, std::vector{ArmWarning::NotEnabled});
  EXPECT_TRUE(measured().isApprox(psmParked()));
}

TEST_F(ArmControllerTest, HomesAndReportsTheGoal) {
  cycles(1);
  arm_.enable();
  arm_.home();
  EXPECT_TRUE(arm_.operating_state().is_busy);
  cycles(1000);
  EXPECT_EQ(heard_.goals, std::vector{true});
  EXPECT_TRUE(arm_.operating_state().is_homed);
  EXPECT_FALSE(arm_.operating_state().is_busy);
  EXPECT_TRUE(measured().isApprox(psmModel().home, 1e-9));
}

TEST_F(ArmControllerTest, ServoCpLagsByTheTimeConstant) {
  makeReady();
  const PoseStamped start = arm_.measured_cp();
  const PoseStamped goal = goalAt({0.001, 0, 0});
  arm_.servo_cp(goal);
  cycles(1);  // the joints follow the set-point from the next cycle on
  EXPECT_EQ(arm_.setpoint_cp().stamp, goal.stamp);
  EXPECT_LT(kinematics::poseError(arm_.setpoint_cp().pose, goal.pose).norm(), 1e-8);
  EXPECT_LT(kinematics::poseError(arm_.measured_cp().pose, start.pose).norm(), 1e-8);
  cycles(10);
  const double moved = (arm_.measured_cp().pose.translation() - start.pose.translation()).norm();
  EXPECT_NEAR(moved, 0.001 * (1 - std::exp(-1)), 1e-6);
  cycles(300);
  EXPECT_LT(kinematics::poseError(arm_.measured_cp().pose, goal.pose).norm(), 1e-8);
}

TEST_F(ArmControllerTest, RefusesGoalsFarOutOfReach) {
  makeReady();
  const PoseStamped before = arm_.setpoint_cp();
  for (int i = 0; i < 3; ++i) {
    arm_.servo_cp(goalAt({1, 0, 0}));
    cycles(1);
  }
  EXPECT_EQ(heard_.warnings, std::vector{ArmWarning::StepTooFar});
  EXPECT_TRUE(arm_.setpoint_cp().pose.isApprox(before.pose));
  arm_.servo_cp(goalAt({0.001, 0, 0}));
  arm_.servo_cp(goalAt({1, 0, 0}));
  cycles(1);
  EXPECT_EQ(heard_.warnings.size(), 2u) << "a refusal after it obeyed again is news";
}

TEST_F(ArmControllerTest, RefusesWhatIsNotAGoal) {
  makeReady();
  const PoseStamped before = arm_.setpoint_cp();
  PoseStamped invalid = goalAt({0.001, 0, 0});
  invalid.valid = false;
  PoseStamped skewed = goalAt({0.001, 0, 0});
  skewed.pose.linear() *= 1.01;
  PoseStamped mirrored = goalAt({0.001, 0, 0});
  mirrored.pose.linear().col(0) *= -1;
  PoseStamped infinite = goalAt({std::numeric_limits<double>::infinity(), 0, 0});
  for (const PoseStamped& goal : {invalid, skewed, mirrored, infinite}) {
    arm_.servo_cp(goal);
    EXPECT_FALSE(arm_.inverse_kinematics(goal).found);
  }
  arm_.servo_jp({{1, 2, 3}, {}});
  arm_.move_jp({{1, 2, 3}, {}});
  cycles(1);
  EXPECT_EQ(heard_.warnings, std::vector{ArmWarning::Malformed});
  EXPECT_TRUE(arm_.setpoint_cp().pose.isApprox(before.pose));
}

TEST_F(ArmControllerTest, MovesSmoothlyBelowTheRateLimit) {
  makeReady();
  Joints goal = psmModel().home;
  goal[0] = 1.0;
  arm_.move_jp(toGoal(goal));
  Joints last = measured();
  while (arm_.operating_state().is_busy) {
    cycles(1);
    EXPECT_LE((measured() - last).cwiseAbs().maxCoeff(), 0.5 * 4 * 0.001 + 1e-9);
    last = measured();
  }
  cycles(200);
  EXPECT_EQ(heard_.goals, std::vector{true});
  EXPECT_TRUE(measured().isApprox(goal, 1e-9));
}

TEST_F(ArmControllerTest, ServoReplacesAMove) {
  makeReady();
  Joints goal = psmModel().home;
  goal[0] = 1.0;
  arm_.move_jp(toGoal(goal));
  cycles(10);
  arm_.servo_jp(toGoal(psmModel().home));
  cycles(300);
  EXPECT_EQ(heard_.goals, std::vector{false});
  EXPECT_TRUE(measured().isApprox(psmModel().home, 1e-9));
}

TEST_F(ArmControllerTest, DisableStopsItUntilEnabled) {
  makeReady();
  arm_.servo_cp(goalAt({0.01, 0, 0}));
  cycles(3);
  arm_.disable();
  const Joints stopped = measured();
  cycles(1);
  arm_.servo_cp(goalAt({0.01, 0, 0}));
  cycles(50);
  EXPECT_LT((measured() - stopped).cwiseAbs().maxCoeff(), 4 * 0.001 + 1e-12);
  EXPECT_EQ(arm_.operating_state().state, ArmState::Disabled);
  EXPECT_TRUE(arm_.operating_state().is_homed);
}

TEST_F(ArmControllerTest, AnswersKinematicQuestions) {
  makeReady();
  const PoseStamped tip = arm_.forward_kinematics(toGoal(psmModel().home));
  ASSERT_TRUE(tip.valid);
  const JointSolution q = arm_.inverse_kinematics(tip);
  ASSERT_TRUE(q.found);
  ASSERT_EQ(q.joints, 6u);
  EXPECT_TRUE(Joints::Map(q.position.data()).isApprox(psmModel().home, 1e-6));
  EXPECT_FALSE(arm_.forward_kinematics({{1, 2}, {}}).valid);
}

TEST_F(ArmControllerTest, JointStatesAreWhole) {
  makeReady();
  const JointState& state = arm_.measured_js();
  EXPECT_EQ(state.name.size(), 6u);
  EXPECT_EQ(state.position.size(), 6u);
  EXPECT_EQ(state.velocity.size(), 6u);
  EXPECT_EQ(state.effort.size(), 6u);
  EXPECT_EQ(state.stamp, time_);
  EXPECT_TRUE(arm_.setpoint_js().velocity.empty());
}

}  // namespace
}  // namespace robots::test
