// These tests say where velocities lead a goal.

#include "person/hand_goal.h"

#include <gtest/gtest.h>

namespace robots::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

TEST(HandGoal, MovesInTheReferenceFrame) {
  Isometry3d start = Isometry3d::Identity();
  start.translation() = Vector3d(0.1, 0.2, 0.3);
  start.linear() = AngleAxisd(1, Vector3d::UnitX()).toRotationMatrix();
  Isometry3d goal = start;
  const HandInput input{
      .velocity = {0.05, 0, -0.02}, .angular_velocity = {0, 0, 0.5}, .opening = {}};
  for (int i = 0; i < 1000; ++i) goal = movedGoal(goal, goal, input, 0.001);
  EXPECT_TRUE(goal.translation().isApprox(Vector3d(0.15, 0.2, 0.28), 1e-9));
  EXPECT_TRUE(goal.linear().isApprox(AngleAxisd(0.5, Vector3d::UnitZ()) * start.linear(), 1e-9));
}

TEST(HandGoal, WaitsForItsArm) {
  Isometry3d goal = Isometry3d::Identity();
  const HandInput input{.velocity = {0, 0, 0.25}, .angular_velocity = {2, 0, 0}, .opening = {}};
  for (int i = 0; i < 10000; ++i) goal = movedGoal(goal, Isometry3d::Identity(), input, 0.001);
  EXPECT_NEAR(goal.translation().z(), kFurthestLead, 1e-9);
  EXPECT_NEAR(AngleAxisd(goal.linear()).angle(), kWidestLead, 1e-3);
}

// This lets an arm at a limit slide along it.
TEST(HandGoal, TurnsAsideAtItsLongestLead) {
  Isometry3d goal = Isometry3d::Identity();
  goal.translation().z() = kFurthestLead;
  const HandInput input{
      .velocity = {0.05, 0, 0}, .angular_velocity = Vector3d::Zero(), .opening = {}};
  goal = movedGoal(goal, Isometry3d::Identity(), input, 0.1);
  EXPECT_GT(goal.translation().x(), 0.004);
  EXPECT_NEAR(goal.translation().norm(), kFurthestLead, 1e-9);
}

}  // namespace
}  // namespace robots::test
