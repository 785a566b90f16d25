// The scripted hand is smooth from rest, bounded, and within what a master can reach.

#include "surgeon/hand_path.h"

#include <gtest/gtest.h>

#include <numbers>

#include "kinematics/davinci.h"
#include "kinematics/inverse.h"
#include "kinematics/pose_error.h"

namespace robots::test {
namespace {

constexpr HandPathShape kShape{.amplitude = 0.1, .turn = 0.3, .frequency = 0.3, .ramp = 1.0};
constexpr double kStep = 0.001;

using Vector6 = Eigen::Matrix<double, 6, 1>;

Eigen::Isometry3d somewhere() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(0.1, -0.4, 0.05);
  pose.linear() = Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return pose;
}

Vector6 velocity(const HandPath& path, double t) {
  return kinematics::poseError(path.at(t), path.at(t + kStep)) / kStep;
}

TEST(HandPath, StartsAtRest) {
  const HandPath path(somewhere(), kShape);
  EXPECT_TRUE(path.at(0).isApprox(somewhere()));
  EXPECT_LT(velocity(path, 0).norm(), 1e-4);
  EXPECT_LT((velocity(path, kStep) - velocity(path, 0)).norm() / kStep, 0.1);
}

TEST(HandPath, HasNoJumpInVelocityOrAcceleration) {
  const HandPath path(somewhere(), kShape);
  Vector6 last = velocity(path, 0), lastAcceleration = Vector6::Zero();
  for (double t = kStep; t < 10; t += kStep) {
    const Vector6 now = velocity(path, t);
    const Vector6 acceleration = (now - last) / kStep;
    // A jump would not shrink with the step: jerk stays bounded.
    ASSERT_LT((acceleration - lastAcceleration).norm() / kStep, 60) << "t = " << t;
    last = now;
    lastAcceleration = acceleration;
  }
}

TEST(HandPath, StaysWithinItsSpeedAndReach) {
  const HandPath path(somewhere(), kShape);
  double reach = 0;
  for (double t = 0; t < 20; t += kStep) {
    ASSERT_LE(velocity(path, t).head<3>().norm(), path.maxSpeed());
    const Eigen::Vector3d offset = path.at(t).translation() - somewhere().translation();
    ASSERT_LE(offset.cwiseAbs().maxCoeff(), kShape.amplitude);
    reach = std::max(reach, offset.norm());
  }
  EXPECT_GT(reach, kShape.amplitude);
}

// Elsewhere is as far from the centre as the path goes, and turned.
TEST(HandPath, ComesBackWithoutAJump) {
  Eigen::Isometry3d elsewhere = somewhere();
  elsewhere.translation() += Eigen::Vector3d(0.1, -0.08, 0.06);
  elsewhere.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  const HandPath path(elsewhere, somewhere(), kShape), around(somewhere(), kShape);
  EXPECT_TRUE(path.at(0).isApprox(elsewhere));
  EXPECT_LT(velocity(path, 0).norm(), 1e-4);
  Vector6 last = velocity(path, 0), lastAcceleration = Vector6::Zero();
  for (double t = kStep; t < 3; t += kStep) {
    const Vector6 now = velocity(path, t);
    const Vector6 acceleration = (now - last) / kStep;
    ASSERT_LT((acceleration - lastAcceleration).norm() / kStep, 60) << "t = " << t;
    ASSERT_LE(now.head<3>().norm(), path.maxSpeed());
    last = now;
    lastAcceleration = acceleration;
  }
  EXPECT_TRUE(path.at(2).isApprox(around.at(2), 1e-9));
  EXPECT_TRUE(path.at(7).isApprox(around.at(7), 1e-9));
}

template <int N>
void expectReachable(const kinematics::Chain<N>& chain, typename kinematics::Chain<N>::Joints q) {
  const HandPath path(chain.forward(q), kShape);
  for (double t = 0; t < 60; t += 0.01) {
    const auto solution = kinematics::inverse(chain, path.at(t), q);
    ASSERT_TRUE(solution.found) << "t = " << t;
    q = solution.q;
  }
}

TEST(HandPath, IsReachableByBothMastersFromHome) {
  kinematics::Chain<7>::Joints home = kinematics::Chain<7>::Joints::Zero();
  home[1] = 0.4;
  home[4] = std::numbers::pi / 2;
  expectReachable(kinematics::mtmLeft(), home);
  expectReachable(kinematics::mtmRight(), home);
}

}  // namespace
}  // namespace robots::test
