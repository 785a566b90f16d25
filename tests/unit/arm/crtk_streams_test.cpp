// These test the commands that have to be repeated: velocities, twists, efforts and forces.
#include <gtest/gtest.h>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class CrtkStreamsTest : public CrtkArmTest {
 protected:
  /// Returns how far the first joint goes in so many cycles of the stream.
  double travel(const JointVelocityGoal& goal, int count) {
    const double before = setpoint(0);
    for (int i = 0; i < count; ++i) {
      crtk_.servo_jv(goal);
      cycles(1);
    }
    return setpoint(0) - before;
  }
};

TEST_F(CrtkStreamsTest, AVelocityMovesUntilItFallsSilent) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 1.0;
  const double before = setpoint(0);
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_jv(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - before, 0.05, 0.002);
  EXPECT_EQ(crtk_.operating_state().sub_state, "servo_jv");
  cycles(90);
  EXPECT_EQ(crtk_.operating_state().sub_state, "servo_jv");
  cycles(20);
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
}

TEST_F(CrtkStreamsTest, AMaskedJointHolds) {
  JointVelocityGoal velocity;
  velocity.goal.assign(6, 0.5);
  velocity.mask = {true, false, true, true, true, true};
  JointEffortGoal effort;
  effort.effort.assign(6, 1.0);
  effort.mask = {false, true, true, true, true, true};
  const double first = setpoint(0), second = setpoint(1);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jv(velocity);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - first, 0.01, 1e-9);
  EXPECT_EQ(setpoint(1), second);
  const double held = setpoint(0);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jf(effort);
    cycles(1);
  }
  EXPECT_EQ(setpoint(0), held);
  EXPECT_NEAR(setpoint(1) - second, 0.01, 1e-9);
}

TEST_F(CrtkStreamsTest, AJointStopsAtItsGuard) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  for (const double direction : {1.0, -1.0}) {
    crtk_.hold();
    goal.goal[0] = direction;
    goal.guard = positions();
    goal.guard[0] += 0.0105 * direction;
    for (int i = 0; i < 30; ++i) {
      crtk_.servo_jv(goal);
      cycles(1);
    }
    EXPECT_EQ(setpoint(0), goal.guard[0]) << direction;
  }
}

TEST_F(CrtkStreamsTest, AGuardBehindDoesNotStopIt) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 1.0;
  goal.guard = positions();
  goal.guard[0] -= 0.01;
  const double before = setpoint(0);
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_jv(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(0) - before, 0.02, 1e-9);
}

TEST_F(CrtkStreamsTest, AVelocityKeepsToItsAccelerations) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 0.1;
  goal.acceleration.assign(6, 10.0);
  goal.deceleration.assign(6, 5.0);
  // The joint is 0.01 rad/s faster each ms: 0.01 + ... + 0.1.
  EXPECT_NEAR(travel(goal, 10), 0.55e-3, 1e-9);
  EXPECT_NEAR(travel(goal, 10), 1e-3, 1e-9);
  goal.goal[0] = -0.1;
  EXPECT_NEAR(travel(goal, 20), 0.95e-3, 1e-9) << "it stands after 20 ms";
  EXPECT_NEAR(travel(goal, 10), -0.55e-3, 1e-9) << "then it comes back";
}

TEST_F(CrtkStreamsTest, ATurningVelocityKeepsItsAcceleration) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 0.1;
  goal.acceleration.assign(6, 10.0);
  EXPECT_NEAR(travel(goal, 10), 0.55e-3, 1e-9);
  goal.goal[0] = -0.1;
  EXPECT_NEAR(travel(goal, 10), -0.55e-3, 1e-9)
      << "it stops within one cycle, and then speeds up by the bound";
}

TEST_F(CrtkStreamsTest, ANewStreamBeginsFromRest) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 0.0);
  goal.goal[0] = 0.1;
  goal.acceleration.assign(6, 10.0);
  travel(goal, 20);
  crtk_.hold();  // one cycle takes this and the next goal
  EXPECT_NEAR(travel(goal, 10), 0.55e-3, 1e-9);
}

TEST_F(CrtkStreamsTest, AnUnreachableTwistIsReportedOnce) {
  // Only another posture of the arm reaches where this leads in one cycle.
  const Eigen::Isometry3d from = crtk_.setpoint_cp().pose,
                          to = crtk_.forward_kinematics({{-0.9, 0.3, 0.1, 3, 0.5, -0.5}, {}}).pose;
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  TwistGoal away;
  away.linear = (to.translation() - from.translation()) / 1e-3;
  away.angular = turn.axis() * turn.angle() / 1e-3;
  const std::vector<double> before = positions();
  const auto follow = [&](const TwistGoal& goal) {
    for (int i = 0; i < 5; ++i) {
      crtk_.servo_cv(goal);
      cycles(1);
    }
  };
  follow(away);
  EXPECT_EQ(heard_.codes, std::vector{ArmWarning::OutOfReach}) << "it is told once";
  EXPECT_EQ(positions(), before);
  follow({});
  EXPECT_EQ(heard_.codes.size(), 1u);
  follow(away);
  EXPECT_EQ(heard_.codes.size(), 2u) << "what begins anew is news";
}

TEST_F(CrtkStreamsTest, NewAxesDoNotTurnTheSpeed) {
  TransformStamped base;
  base.transform.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  base.valid = true;
  crtk_.set_base_frame(base);
  cycles(1);
  WrenchGoal push;  // it acts along the base's axes
  push.force.x() = 5;
  for (int i = 0; i < 20; ++i) {
    crtk_.spatial_servo_cf(push);
    cycles(1);
  }
  const PoseStamped before = crtk_.setpoint_cp();
  TwistGoal stand;  // it is along the axes of the reference frame, which point elsewhere
  stand.linear_acceleration = {0.1, 0.1, 0.1};
  crtk_.servo_cv(stand);
  cycles(1);
  expectMoved(before, {0, 0, 0});
}

TEST_F(CrtkStreamsTest, ATwistKeepsToItsAcceleration) {
  TransformStamped base;
  base.transform.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  base.valid = true;
  crtk_.set_base_frame(base);
  cycles(1);
  TwistGoal goal;
  goal.linear = {0.02, 0.02, 0};
  goal.linear_acceleration = {1, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 20; ++i) {
    crtk_.servo_cv(goal);
    cycles(1);
  }
  expectMoved(before, {0.21e-3, 0.4e-3, 0});
}

TEST_F(CrtkStreamsTest, ATwistKeepsEachJointsRate) {
  TwistGoal goal;
  goal.linear = {50, 50, 0};
  std::vector<double> before = positions();
  double fastest = 0;
  for (int cycle = 0; cycle < 5; ++cycle) {
    crtk_.servo_cv(goal);
    cycles(1);
    for (std::size_t i = 0; i < before.size(); ++i) {
      fastest = std::max(fastest, std::abs(positions()[i] - before[i]));
    }
    before = positions();
  }
  EXPECT_LE(fastest, 4 * 0.001 + 1e-12);
  EXPECT_GT(fastest, 0.001);
}

TEST_F(CrtkStreamsTest, BoundsThatMakeNoSenseAreRefused) {
  JointVelocityGoal fine;
  fine.goal.assign(6, 0.1);
  const auto expectRefused = [&](const JointVelocityGoal& goal, const char* what) {
    crtk_.hold();
    cycles(1);
    const double before = setpoint(0);
    crtk_.servo_jv(goal);
    cycles(2);
    EXPECT_EQ(setpoint(0), before) << what;
    EXPECT_NE(crtk_.operating_state().sub_state, "servo_jv") << what;
  };
  JointVelocityGoal goal = fine;
  goal.mask.assign(5, true);
  expectRefused(goal, "a mask of five");
  goal = fine;
  goal.guard.assign(7, 0.0);
  expectRefused(goal, "a guard of seven");
  goal = fine;
  goal.acceleration.assign(6, 0.0);
  expectRefused(goal, "no acceleration");
  goal = fine;
  goal.deceleration.assign(6, std::nan(""));
  expectRefused(goal, "a deceleration that is no number");
  TwistGoal twist;
  twist.linear = {0.1, 0, 0};
  twist.linear_acceleration = {-1, 0, 0};
  crtk_.servo_cv(twist);
  cycles(1);
  EXPECT_NE(crtk_.operating_state().sub_state, "servo_cv");
}

TEST_F(CrtkStreamsTest, HoldEndsAStream) {
  JointVelocityGoal goal;
  goal.goal.assign(6, 1.0);
  crtk_.servo_jv(goal);
  cycles(2);
  crtk_.hold();
  cycles(1);
  const double held = setpoint(0);
  cycles(10);
  EXPECT_EQ(setpoint(0), held);
}

TEST_F(CrtkStreamsTest, ATwistMovesInTheReferenceFrame) {
  TwistGoal goal;
  goal.linear = {0.02, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_cv(goal);
    cycles(1);
  }
  expectMoved(before, {0.001, 0, 0});
  EXPECT_NEAR(crtk_.setpoint_cv().linear.x(), 0.02, 1e-5);
  EXPECT_NEAR(crtk_.measured_cv().linear.x(), 0.02, 0.002);
}

TEST_F(CrtkStreamsTest, AForcePushes) {
  WrenchGoal goal;
  goal.force = {1, 0, 0};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.spatial_servo_cf(goal);
    cycles(1);
  }
  expectMoved(before, {0.001, 0, 0});
}

TEST_F(CrtkStreamsTest, ABodyForcePushesAlongTheTip) {
  WrenchGoal goal;
  goal.force = {0, 0, 1};
  const PoseStamped before = crtk_.setpoint_cp();
  for (int i = 0; i < 50; ++i) {
    crtk_.body_servo_cf(goal);
    cycles(1);
  }
  expectMoved(before, 0.001 * before.pose.linear().col(2));
}

TEST_F(CrtkStreamsTest, AnEffortMovesItsJoint) {
  JointEffortGoal goal;
  goal.effort.assign(6, 0.0);
  goal.effort[1] = 2.0;
  const double before = setpoint(1);
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_jf(goal);
    cycles(1);
  }
  EXPECT_NEAR(setpoint(1) - before, 0.05, 0.002);
}

}  // namespace
}  // namespace robots::test
