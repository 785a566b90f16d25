// These goals come more slowly than the arm's cycles: the set-point goes to each in a line.
#include <gtest/gtest.h>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class InterpolationTest : public CrtkArmTest {
 protected:
  /// Returns a goal with that much of the first joint, which can do 4 rad/s and a servo step of 0.4
  /// rad.
  static JointGoal yaw(double by) { return {{by, 0, 0, 0, 0, 0}, {}}; }
};

TEST_F(InterpolationTest, TheFirstGoalKeepsTheRateLimit) {
  crtk_.interpolate_jr({{0.4, 0.04, 0, 0, 0, 0}, {}});
  cycles(50);
  EXPECT_NEAR(setpoint(0), 0.3, 1e-9);
  EXPECT_NEAR(setpoint(1), 0.12, 1e-9) << "both arrive together";
  cycles(60);
  EXPECT_NEAR(setpoint(0), 0.5, 1e-9);
  cycles(300);
  EXPECT_NEAR(setpoint(0), 0.5, 1e-9) << "it stays there";
  EXPECT_EQ(crtk_.operating_state().sub_state, "interpolate_jr");
}

TEST_F(InterpolationTest, AStreamIsFollowedSteadily) {
  JointGoal goal{positions(), {}};
  double last = setpoint(0);
  for (int i = 0; i < 10; ++i) {
    goal.position[0] += 0.005;
    goal.stamp = suture::fromNanoseconds(1000 + i);
    crtk_.interpolate_jp(goal);
    for (int cycle = 0; cycle < 20; ++cycle) {
      cycles(1);
      if (i > 1) {
        EXPECT_NEAR(setpoint(0) - last, 0.005 / 20, 1e-6) << i << ", " << cycle;
      }
      last = setpoint(0);
    }
    EXPECT_EQ(crtk_.setpoint_cp().stamp, goal.stamp);
  }
}

TEST_F(InterpolationTest, RelativeGoalsOfOneCycleAddUp) {
  const double before = setpoint(0);
  crtk_.interpolate_jr(yaw(0.01));
  crtk_.interpolate_jr(yaw(0.01));
  cycles(20);
  EXPECT_NEAR(setpoint(0), before + 0.02, 1e-9);
  const PoseStamped pose = crtk_.setpoint_cp();
  crtk_.interpolate_cr(step({0, 0, 0.001}));
  crtk_.interpolate_cr(step({0, 0.001, 0}));
  cycles(200);
  expectMoved(pose, {0, 0.001, 0.001});
}

TEST_F(InterpolationTest, ASecondGoalKeepsTheRate) {
  for (int i = 0; i < 3; ++i) {
    crtk_.interpolate_jr(yaw(0.01));
    cycles(50);
  }
  const double before = setpoint(0);
  crtk_.interpolate_jr(yaw(0.01));
  crtk_.interpolate_jr(yaw(0));
  cycles(1);
  EXPECT_NEAR(setpoint(0) - before, 0.01 / 50, 1e-6);
}

TEST_F(InterpolationTest, AnotherPosturesGoalIsRefused) {
  const PoseStamped before = crtk_.setpoint_cp();
  PoseStamped goal = crtk_.forward_kinematics({{-0.9, 0.3, 0.1, 3, 0.5, -0.5}, {}});
  crtk_.interpolate_cp(goal);
  cycles(500);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::OutOfReach});
  expectMoved(before, {0, 0, 0});
}

TEST_F(InterpolationTest, ACartesianGoalIsReached) {
  const PoseStamped before = crtk_.setpoint_cp();
  PoseStamped goal = before;
  goal.pose.translation() += Eigen::Vector3d(0.003, 0, 0);
  crtk_.interpolate_cp(goal);
  cycles(200);
  expectMoved(before, {0.003, 0, 0});
  crtk_.interpolate_cr(step({0, 0.002, 0}));
  cycles(200);
  expectMoved(before, {0.003, 0.002, 0});
}

TEST_F(InterpolationTest, AFarGoalIsAccepted) {
  crtk_.interpolate_jr(yaw(0.6));
  crtk_.servo_jr(yaw(0.6));
  cycles(1);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::StepTooFar}) << "of the servo command alone";
}

TEST_F(InterpolationTest, EndsWithAnyOtherCommand) {
  crtk_.interpolate_jr(yaw(0.4));
  cycles(20);
  crtk_.hold();
  const double held = setpoint(0);
  cycles(100);
  EXPECT_EQ(setpoint(0), held);
  EXPECT_LT(held, 0.5);
}

TEST_F(InterpolationTest, InvalidGoalsAreRefused) {
  crtk_.interpolate_cp(PoseStamped{});
  crtk_.interpolate_jr({{1, 2, 3}, {}});
  cycles(1);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::Malformed});
  crtk_.disable();
  crtk_.interpolate_jr(joints(0.01));
  cycles(1);
  EXPECT_EQ(heard_.codes.back(), ArmWarning::NotEnabled);
}

TEST_F(InterpolationTest, SlidesAlongALimitAndSaysSo) {
  JointGoal goal{positions(), {}};
  goal.position[0] = 2;
  crtk_.interpolate_jp(goal);
  cycles(2000);
  EXPECT_NEAR(setpoint(0), psmModel().chain.upper()[0], 1e-9);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::AtLimit});
}

}  // namespace
}  // namespace robots::test
