// These test what an arm measures at its tip, of what its drives measure of its joints.

#include <gtest/gtest.h>

#include "arm_control/tip_force.h"
#include "dynamics/davinci_inertia.h"
#include "unit/arm/crtk_arm_fixture.h"

namespace robots::test {
namespace {

using Joints = ArmModel<6>::Joints;

ArmModel<6> heavyModel() {
  ArmModel<6> model = psmModel();
  model.weight = dynamics::ArmDynamics<6>(model.chain, dynamics::psmMechanics().links);
  return model;
}

class MeasuredForceTest : public CrtkArmTest {
 protected:
  explicit MeasuredForceTest(const ArmModel<6>& model = heavyModel()) : CrtkArmTest(model) {}

  /// The motors carry the arm, and press with `wrench` at the tip.
  void press(const kinematics::SpatialVector& wrench) {
    const Joints q = Joints::Map(crtk_.measured_js().position.data());
    const auto& weight = *model_.weight;
    joints_.draw(weight.gravity(weight.at(q)) + model_.chain.jacobian(q).transpose() * wrench);
    cycles(1);
  }
  void expectNone(const char* why) {
    EXPECT_FALSE(crtk_.spatial_measured_cf().valid) << why;
    EXPECT_FALSE(crtk_.body_measured_cf().valid) << why;
    EXPECT_FALSE(crtk_.measured_cs().force_is_valid) << why;
    EXPECT_EQ(crtk_.spatial_measured_cf().force.norm(), 0) << why;
  }

  const ArmModel<6> model_ = heavyModel();
  const kinematics::SpatialVector wrench_{1, -2, 3, 0.01, 0.02, -0.03};
};

TEST_F(MeasuredForceTest, IsTheEffortBesideTheWeight) {
  press(wrench_);
  const Wrench& spatial = crtk_.spatial_measured_cf();
  ASSERT_TRUE(spatial.valid);
  EXPECT_EQ(spatial.stamp, crtk_.measured_js().stamp);
  EXPECT_LT((spatial.force - wrench_.head<3>()).norm(), 1e-6);
  EXPECT_LT((spatial.torque - wrench_.tail<3>()).norm(), 1e-6);
  const Eigen::Matrix3d tip = crtk_.local_measured_cp().pose.linear();
  const Wrench& body = crtk_.body_measured_cf();
  ASSERT_TRUE(body.valid);
  EXPECT_LT((tip * body.force - spatial.force).norm(), 1e-9);
  EXPECT_LT((tip * body.torque - spatial.torque).norm(), 1e-9);
}

TEST_F(MeasuredForceTest, TheForceIsInTheReferenceFrame) {
  TransformStamped base;
  base.transform.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  base.valid = true;
  crtk_.set_base_frame(base);
  press(wrench_);
  ASSERT_TRUE(crtk_.measured_cs().force_is_valid);
  EXPECT_LT((crtk_.measured_cs().force - base.transform.linear() * wrench_.head<3>()).norm(), 1e-6);
}

TEST_F(MeasuredForceTest, IsNotWhatACommandAsksFor) {
  press(kinematics::SpatialVector::Zero());
  WrenchGoal goal;
  goal.force = {1, 0, 0};
  crtk_.spatial_servo_cf(goal);
  cycles(1);
  ASSERT_TRUE(crtk_.spatial_measured_cf().valid);
  EXPECT_LT(crtk_.spatial_measured_cf().force.norm(), 0.01) << "the motors do not press";
}

TEST_F(MeasuredForceTest, NeedsDrivesThatMeasureEffort) {
  press(wrench_);
  joints_.measureNoEffort();
  cycles(1);
  expectNone("no drive measures it");
  EXPECT_TRUE(crtk_.measured_js().effort.empty());
  EXPECT_TRUE(crtk_.measured_js().valid);
}

TEST_F(MeasuredForceTest, IsNotThereWithoutPower) {
  press(wrench_);
  crtk_.disable();
  cycles(2);
  expectNone("the brakes bear it");
  EXPECT_EQ(crtk_.measured_js().effort.size(), 6u);
}

TEST_F(MeasuredForceTest, NeedsDrivesThatAnswer) {
  press(wrench_);
  arm_.step(time_ += 1ms, std::nullopt);
  crtk_.publish(time_);
  expectNone("nobody told it");
}

// With the tip at the remote centre no effort of the first joints is a force.
TEST_F(MeasuredForceTest, IsNotThereBesideASingularity) {
  JointGoal goal = joints(0);
  goal.position[2] = 0.4318 - 0.4162 - 0.0091;
  crtk_.move_jp(goal);
  while (crtk_.operating_state().is_busy) cycles(1);
  cycles(200);
  press(wrench_);
  expectNone("any force would fit");
}

TEST(TipForce, FitsTheEffortsOfSevenJoints) {
  const auto chain = kinematics::mtmLeft();
  const auto jacobian = chain.jacobian(kinematics::mtmHome());
  const kinematics::SpatialVector wrench{1, -2, 3, 0.1, 0.2, -0.3};
  const Eigen::Matrix<double, 7, 1> effort = jacobian.transpose() * wrench;
  const auto told = tipForce<7>(jacobian, effort);
  ASSERT_TRUE(told);
  EXPECT_LT((*told - wrench).norm(), 1e-9);
  // These efforts turn the arm about its tip without moving the tip, so they press with nothing.
  const Eigen::Matrix<double, 7, 1> still = jacobian.fullPivLu().kernel().col(0);
  const auto same = tipForce<7>(jacobian, effort + still);
  ASSERT_TRUE(same);
  EXPECT_LT((*same - wrench).norm(), 1e-9);
}

}  // namespace
}  // namespace robots::test
