// This is the teleoperation law x_s = x_s0 + s (x_m - x_m0), R_s = R_m R_m0^T R_s0.

#include "teleop/follow_law.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace robots::test {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d randomPose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = Vector3d(normal(random), normal(random), normal(random));
  return pose;
}

TEST(FollowLaw, IdentityAnchorsCopyTheMaster) {
  std::mt19937 random(4);
  const FollowLaw law(Isometry3d::Identity(), Isometry3d::Identity(), {});
  for (int i = 0; i < 100; ++i) {
    const Isometry3d master = randomPose(random);
    EXPECT_TRUE(law.follow(master).isApprox(master, 1e-14));
  }
}

TEST(FollowLaw, DoesNotJumpAtEntry) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Isometry3d master = randomPose(random), slave = randomPose(random);
    EXPECT_TRUE(FollowLaw(master, slave, {.scale = 0.2}).follow(master).isApprox(slave, 1e-14));
  }
}

TEST(FollowLaw, ScalesTranslationAndNotRotation) {
  Isometry3d master = Isometry3d::Identity();
  const FollowLaw law(master, Isometry3d::Identity(), {.scale = 0.2});
  master.translate(Vector3d(0.1, -0.2, 0.3));
  master.rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitY()));
  const Isometry3d slave = law.follow(master);
  EXPECT_TRUE(slave.translation().isApprox(Vector3d(0.02, -0.04, 0.06), 1e-14));
  EXPECT_TRUE(slave.linear().isApprox(master.linear(), 1e-14));
}

TEST(FollowLaw, AnchorsDoNotChangeTheMotion) {
  std::mt19937 random(6);
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::uniform_real_distribution(0.05, 2.0)(random);
    const FollowLaw law(randomPose(random), randomPose(random), {.scale = scale});
    const Isometry3d before = randomPose(random), after = randomPose(random);
    const Isometry3d from = law.follow(before), to = law.follow(after);
    const Vector3d moved = scale * (after.translation() - before.translation());
    EXPECT_TRUE((to.translation() - from.translation()).isApprox(moved, 1e-12));
    // The rotation between two slave poses equals the one between the master's, in the base frame.
    EXPECT_TRUE((to.linear() * from.linear().transpose())
                    .isApprox(after.linear() * before.linear().transpose(), 1e-12));
    EXPECT_TRUE((to.linear() * to.linear().transpose()).isIdentity(1e-12));
  }
}

TEST(FollowLaw, OnlyAcceptsAFinitePositiveScale) {
  EXPECT_TRUE(FollowLaw::isValidScale(0.2));
  EXPECT_TRUE(FollowLaw::isValidScale(1.5));
  for (const double scale : {0.0, -0.2, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(FollowLaw::isValidScale(scale)) << scale;
  }
}

}  // namespace
}  // namespace robots::test
