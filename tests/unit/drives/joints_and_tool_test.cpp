// These test the joint of a tool behind those of its arm, and the gripper that a hand holds.

#include "drives/joints_and_tool.h"

#include <gtest/gtest.h>

#include <limits>

#include "drives/held_gripper.h"
#include "drives/joint_dynamics.h"

namespace robots::test {
namespace {

constexpr double kLag = 0.01;

template <int N>
JointDynamics<N> lagging(double parked) {
  using Joints = typename JointDynamics<N>::Joints;
  return {kLag, Joints::Constant(4), Joints::Constant(-1), Joints::Constant(1),
          Joints::Constant(parked)};
}

TEST(JointsAndTool, AreOneSetOfJoints) {
  JointsAndTool<2> all(std::make_unique<JointDynamics<2>>(lagging<2>(0.1)),
                       std::make_shared<JointDynamics<1>>(lagging<1>(0.2)));
  EXPECT_EQ(all.measured(), Eigen::Vector3d(0.1, 0.1, 0.2));
  all.command({0.3, 0.1, 0.5});
  EXPECT_EQ(all.velocity(), Eigen::Vector3d(4, 0, 4));
  all.advance(1);
  EXPECT_TRUE(all.measured().isApprox(Eigen::Vector3d(0.3, 0.1, 0.5)));
  all.command({0, 0, 0});
  all.brake();
  all.advance(1);
  EXPECT_TRUE(all.measured().isApprox(Eigen::Vector3d(0.3, 0.1, 0.5)));
}

TEST(HeldGripper, IsOpenUntilItIsSqueezed) {
  HeldGripper gripper(kLag);
  EXPECT_EQ(gripper.measured().value(), kinematics::kMtmGripper.upper);
  gripper.squeeze(0.2);
  gripper.advance(1);
  EXPECT_NEAR(gripper.measured().value(), 0.2, 1e-9);
  gripper.squeeze(-9);
  gripper.advance(1);
  EXPECT_NEAR(gripper.measured().value(), kinematics::kMtmGripper.lower, 1e-9);
}

TEST(HeldGripper, MovesForFingersAlone) {
  HeldGripper gripper(kLag);
  gripper.squeeze(0.2);
  gripper.squeeze(std::numeric_limits<double>::quiet_NaN());
  gripper.command(HeldGripper::Joints(0.7));
  gripper.brake();
  gripper.advance(1);
  EXPECT_NEAR(gripper.measured().value(), 0.2, 1e-9);
}

}  // namespace
}  // namespace robots::test
