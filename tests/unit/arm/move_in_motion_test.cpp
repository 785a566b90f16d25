// These moves begin while the set-point moves.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

constexpr double kAcceleration = 40, kDt = 0.001;

ArmModel<6> acceleratingModel() {
  ArmModel<6> model = psmModel();
  model.acceleration_limit.setConstant(kAcceleration);
  model.effort_limit.setConstant(0.3);
  return model;
}

class MoveInMotion : public CrtkArmTest {
 protected:
  MoveInMotion() : CrtkArmTest(acceleratingModel()) {}

  static JointGoal yaw(double value) {
    JointGoal goal = joints(0.1);
    goal.position[0] = value;
    return goal;
  }
  /// The set-point's velocity changes by no more than accelerations allow in each cycle, from now
  /// until it rests at `goal`.
  void expectSmoothTo(double goal, double velocity) {
    double last = setpoint(0);
    double rate = velocity;
    double fastest = 0;
    for (int i = 0; i < 3000 && heard_.goals != std::vector{true}; ++i) {
      cycles(1);
      const double now = (setpoint(0) - last) / kDt;
      ASSERT_LT(std::abs(now - rate), 1.1 * kAcceleration * kDt) << "in cycle " << i;
      fastest = std::max(fastest, std::abs(now));
      rate = now;
      last = setpoint(0);
    }
    EXPECT_EQ(heard_.goals, std::vector{true});
    EXPECT_DOUBLE_EQ(setpoint(0), goal);
    EXPECT_LE(fastest, 4 + 1e-9);
  }
};

TEST_F(MoveInMotion, GoesOnFromAStreamOfVelocities) {
  JointVelocityGoal rates;
  rates.goal.assign(6, 0);
  rates.goal[0] = 1.5;
  for (int i = 0; i < 100; ++i) {
    crtk_.servo_jv(rates);
    cycles(1);
  }
  crtk_.move_jp(yaw(-0.3));
  expectSmoothTo(-0.3, 1.5);
}

TEST_F(MoveInMotion, GoesOnFromAStreamOfGoals) {
  for (const int every : {1, 2, 20}) {
    heard_ = {};
    double goal = setpoint(0);
    for (int i = 0; i < 10; ++i) {
      crtk_.servo_jp(yaw(goal += 0.8 * kDt * every));
      cycles(every);
    }
    crtk_.move_jp(yaw(0.5));
    double last = setpoint(0);
    cycles(1);
    EXPECT_NEAR((setpoint(0) - last) / kDt, 0.8, kAcceleration * kDt) << "every " << every;
    while (heard_.goals.empty()) cycles(1);
    EXPECT_DOUBLE_EQ(setpoint(0), 0.5);
  }
}

TEST_F(MoveInMotion, GoesOnFromAnInterpolation) {
  for (int i = 1; i <= 6; ++i) {
    crtk_.interpolate_jp(yaw(0.1 + 0.02 * i));
    cycles(20);
  }
  const double before = setpoint(0);
  crtk_.interpolate_jp(yaw(0.24));
  cycles(10);
  const double velocity = (setpoint(0) - before) / (10 * kDt);
  ASSERT_NEAR(velocity, 1, 0.05);
  crtk_.move_jp(yaw(0));
  expectSmoothTo(0, velocity);
}

TEST_F(MoveInMotion, GoesOnFromAnotherMove) {
  crtk_.move_jp(yaw(1));
  cycles(240);
  const double before = setpoint(0);
  cycles(1);
  const double velocity = (setpoint(0) - before) / kDt;
  ASSERT_GT(velocity, 1);
  crtk_.move_jp(yaw(-0.2));
  cycles(0);
  heard_.goals.clear();
  double last = setpoint(0);
  cycles(1);
  EXPECT_EQ(heard_.goals, std::vector{false});
  EXPECT_NEAR((setpoint(0) - last) / kDt, velocity, 1.1 * kAcceleration * kDt);
  heard_.goals.clear();
  expectSmoothTo(-0.2, (setpoint(0) - last) / kDt);
}

TEST_F(MoveInMotion, BeginsAtRestAfterHold) {
  JointVelocityGoal rates;
  rates.goal.assign(6, 1);
  for (int i = 0; i < 50; ++i) {
    crtk_.servo_jv(rates);
    cycles(1);
  }
  crtk_.hold();
  crtk_.move_jp(yaw(0.5));
  double before = setpoint(0);
  cycles(1);
  EXPECT_NEAR(setpoint(0), before, 1e-5);
  while (heard_.goals.empty()) cycles(1);
  crtk_.servo_jp(yaw(0.6));
  cycles(1);
  crtk_.move_jp(yaw(0.5));
  before = setpoint(0);
  cycles(1);
  EXPECT_NEAR(setpoint(0), before, 1e-5) << "a goal that lay far away is no velocity";
}

TEST_F(MoveInMotion, StaysWithinTheLimitsOfPosition) {
  const double most = kinematics::psm().upper()[0];
  crtk_.move_jp(yaw(most - 0.01));
  while (heard_.goals.empty()) cycles(1);
  JointVelocityGoal rates;
  rates.goal.assign(6, 0);
  rates.goal[0] = 4;
  for (int i = 0; i < 2; ++i) {
    crtk_.servo_jv(rates);
    cycles(1);
  }
  heard_ = {};
  crtk_.move_jp(yaw(0.1));
  while (heard_.goals.empty()) {
    cycles(1);
    ASSERT_LE(setpoint(0), most);
  }
  EXPECT_DOUBLE_EQ(setpoint(0), 0.1);
}

TEST_F(MoveInMotion, KeepsItsAccelerationNearALimit) {
  const double most = kinematics::psm().upper()[0];
  const double velocity = 2;
  // Full deceleration ends within 0.05 rad, half of it would take 0.1.
  const double room = 0.07;
  crtk_.move_jp(yaw(most - room - 100 * velocity * kDt));
  while (heard_.goals.empty()) cycles(1);
  JointVelocityGoal rates;
  rates.goal.assign(6, 0);
  rates.goal[0] = velocity;
  for (int i = 0; i < 100; ++i) {
    crtk_.servo_jv(rates);
    cycles(1);
  }
  heard_ = {};
  crtk_.move_jp(yaw(0.1));
  expectSmoothTo(0.1, velocity);
}

TEST_F(MoveInMotion, TheConfigurationTellsAccelerationsAndEfforts) {
  EXPECT_EQ(crtk_.configuration_js().acceleration_max, std::vector<double>(6, kAcceleration));
  EXPECT_EQ(crtk_.configuration_js().acceleration_min, std::vector<double>(6, -kAcceleration));
  EXPECT_EQ(crtk_.configuration_js().effort_max, std::vector<double>(6, 0.3));
  EXPECT_EQ(crtk_.configuration_js().effort_min, std::vector<double>(6, -0.3));
}

}  // namespace
}  // namespace robots::test
