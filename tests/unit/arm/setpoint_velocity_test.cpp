// setpoint_cv is how the set-point moves, whatever moves it.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <utility>

#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

class SetpointVelocityTest : public CrtkArmTest {
 protected:
  SetpointVelocityTest() {
    TransformStamped base;
    base.transform.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    base.valid = true;
    crtk_.set_base_frame(base);
    cycles(1);
  }

  static constexpr int kBegun = 12;  // cycles, after which slow goals have become a stream

  /// Compares setpoint_cv with how far setpoint_cp moves and turns in each of 60 cycles.
  void expectIsThatOfTheSetpoint(const char* what, const std::function<void()>& follow) {
    Eigen::Isometry3d before = crtk_.setpoint_cp().pose;
    double fastest = 0;
    for (int i = 0; i < 60; ++i) {
      follow();
      cycles(1);
      const Eigen::Isometry3d after = crtk_.setpoint_cp().pose;
      const Twist& told = crtk_.setpoint_cv();
      ASSERT_TRUE(told.valid);
      EXPECT_EQ(told.stamp, time_);
      const Eigen::AngleAxisd turned(after.linear() * before.linear().transpose());
      const Eigen::Vector3d linear = (after.translation() - before.translation()) / 0.001;
      const Eigen::Vector3d angular = turned.angle() / 0.001 * turned.axis();
      if (i >= kBegun) {
        EXPECT_LT((told.linear - linear).norm(), 0.01 * linear.norm() + 1e-4) << what << i;
        EXPECT_LT((told.angular - angular).norm(), 0.01 * angular.norm() + 1e-3) << what << i;
      }
      fastest = std::max(fastest, told.linear.norm());
      before = after;
    }
    EXPECT_GT(fastest, 0.005) << what;
    crtk_.hold();
    cycles(200);
    EXPECT_EQ(crtk_.setpoint_cv().linear.norm(), 0) << what << "it rests";
  }
  static PoseStamped forwards() { return step({1e-5, 0, 1e-5}); }
};

TEST_F(SetpointVelocityTest, IsThatOfAPose) {
  PoseStamped goal = crtk_.setpoint_cp();
  expectIsThatOfTheSetpoint("servo_cp, cycle ", [&] {
    goal.pose.translation().x() += 1e-5;
    goal.pose.linear() = goal.pose.linear() * Eigen::AngleAxisd(1e-4, Eigen::Vector3d::UnitX());
    crtk_.servo_cp(goal);
  });
}

TEST_F(SetpointVelocityTest, IsThatOfAStep) {
  expectIsThatOfTheSetpoint("servo_cr, cycle ", [&] { crtk_.servo_cr(forwards()); });
}

TEST_F(SetpointVelocityTest, IsThatOfATwist) {
  TwistGoal twist;
  twist.linear.x() = 0.01;
  expectIsThatOfTheSetpoint("servo_cv, cycle ", [&] { crtk_.servo_cv(twist); });
}

TEST_F(SetpointVelocityTest, IsThatOfInterpolation) {
  int cycle = 0;
  PoseStamped goal = crtk_.setpoint_cp();
  expectIsThatOfTheSetpoint("interpolate_cp, cycle ", [&] {
    if (cycle++ % 10 != 0) return;
    goal.pose.translation().x() += 1e-4;
    crtk_.interpolate_cp(goal);
  });
}

TEST_F(SetpointVelocityTest, IsThatOfAMove) {
  bool asked = false;
  expectIsThatOfTheSetpoint("move_cr, cycle ", [&] {
    if (!std::exchange(asked, true)) crtk_.move_cr(step({0.01, 0, 0.01}));
  });
}

TEST_F(SetpointVelocityTest, IsZeroAfterAJump) {
  cycles(300);
  JointGoal goal{positions(), {}};
  goal.position[0] += 0.3;
  crtk_.servo_jp(goal);
  for (int i = 0; i < 50; ++i) {
    cycles(1);
    EXPECT_EQ(crtk_.setpoint_cv().linear.norm(), 0);
  }
}

TEST_F(SetpointVelocityTest, JacobiansHaveTheStampOfTheirJoints) {
  arm_.step(time_ += 1ms, std::nullopt);
  crtk_.publish(time_);
  EXPECT_EQ(crtk_.spatial_jacobian().stamp, crtk_.measured_js().stamp);
  EXPECT_EQ(crtk_.body_jacobian().stamp, crtk_.measured_js().stamp);
  EXPECT_LT(crtk_.body_jacobian().stamp, time_);
}

}  // namespace
}  // namespace robots::test
