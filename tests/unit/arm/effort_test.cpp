// These test what an arm asks of the motors if its drives control efforts.

#include <gtest/gtest.h>

#include <vector>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

ArmModel<6> limitedModel() {
  ArmModel<6> model = psmModel();
  model.effort_limit.setConstant(2);
  return model;
}

class EffortTest : public CrtkArmTest {
 protected:
  using Efforts = ArmModel<6>::Joints;

  EffortTest() : CrtkArmTest(limitedModel()) {
    joints_.controlEfforts();
    cycles(1);
    goal_.effort = {1, -5, 0, 0, 0, 0.5};
    wrench_.force = {1, 2, -3};
  }

  Eigen::Index released() const { return crtk_.motorOrder().released.count(); }
  /// Expects that the motors hold all joints and add no effort.
  void expectHeld(const char* when) const {
    EXPECT_EQ(released(), 0) << when;
    EXPECT_EQ(crtk_.motorOrder().effort.norm(), 0) << when;
  }

  JointEffortGoal goal_;
  WrenchGoal wrench_;
};

TEST_F(EffortTest, IsTheStreamWithinEachJointsLimit) {
  crtk_.servo_jf(goal_);
  cycles(1);
  Efforts expected;
  expected << 1, -2, 0, 0, 0, 0.5;
  EXPECT_EQ(crtk_.motorOrder().effort, expected);
  EXPECT_EQ(released(), 6);
}

TEST_F(EffortTest, LeavesJointsOutsideOfTheMaskHeld) {
  goal_.mask = {true, false, true, true, true, true};
  crtk_.servo_jf(goal_);
  cycles(1);
  const auto order = crtk_.motorOrder();
  EXPECT_FALSE(order.released[1]);
  EXPECT_EQ(order.effort[1], 0);
  EXPECT_EQ(released(), 5);
}

TEST_F(EffortTest, AWrenchBecomesMatchingEfforts) {
  const kinematics::SpatialVector wrench{0.1, 0.2, -0.3, 0, 0, 0};
  wrench_.force = wrench.head<3>();
  crtk_.spatial_servo_cf(wrench_);
  cycles(1);
  const Efforts at = Efforts::Map(crtk_.measured_js().position.data());
  const Efforts effort = limitedModel().chain.jacobian(at).transpose() * wrench;
  EXPECT_LT((crtk_.motorOrder().effort - effort).norm(), 1e-9);
  EXPECT_EQ(released(), 6);
}

TEST_F(EffortTest, ExcessiveForceKeepsItsDirection) {
  wrench_.force /= 10;
  crtk_.body_servo_cf(wrench_);
  cycles(1);
  const Efforts small = crtk_.motorOrder().effort;
  wrench_.force *= 1000;
  crtk_.body_servo_cf(wrench_);
  cycles(1);
  const Efforts large = crtk_.motorOrder().effort;
  EXPECT_NEAR(large.cwiseAbs().maxCoeff(), 2, 1e-9);
  EXPECT_LT((large.normalized() - small.normalized()).norm(), 1e-6);
}

TEST_F(EffortTest, LetsTheSetPointFollowTheJoints) {
  crtk_.servo_jp(joints(0.3));
  cycles(1);
  crtk_.servo_jf(goal_);
  cycles(50);
  EXPECT_NEAR(setpoint(0), crtk_.measured_js().position[0], 1e-3);
}

TEST_F(EffortTest, EndsWithItsStreamAndState) {
  crtk_.servo_jf(goal_);
  cycles(90);
  EXPECT_EQ(released(), 6);
  cycles(20);
  expectHeld("when the stream is silent");
  EXPECT_EQ(crtk_.operating_state().sub_state, "holding");
  crtk_.servo_jf(goal_);
  crtk_.pause();
  cycles(1);
  expectHeld("when the arm is paused");
  crtk_.servo_jf(goal_);
  cycles(1);
  expectHeld("when the goal is refused");
  crtk_.resume();
  crtk_.servo_jf(goal_);
  cycles(1);
  EXPECT_EQ(released(), 6);
  joints_.force(DrivePower::Stopped);
  cycles(1);
  expectHeld("when the drives have stopped");
}

TEST_F(EffortTest, RequiresAnEnabledArmWithKnownTip) {
  goal_.effort.pop_back();
  crtk_.servo_jf(goal_);
  cycles(1);
  expectHeld("with a list of the wrong length");
  goal_.effort.push_back(0);
  crtk_.unhome();
  crtk_.body_servo_cf(wrench_);
  cycles(1);
  expectHeld("with a wrench of an arm that is not homed");
  crtk_.disable();
  crtk_.servo_jf(goal_);
  crtk_.free();
  cycles(1);
  expectHeld("without power");
  EXPECT_EQ(heard_.codes,
            (std::vector{ArmWarning::Malformed, ArmWarning::NotHomed, ArmWarning::NotEnabled}));
}

}  // namespace
}  // namespace robots::test
