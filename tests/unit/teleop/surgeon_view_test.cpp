// The view of a surgeon is a rotation, however roughly a registration knows its frames.

#include "registration/surgeon_view.h"

#include <gtest/gtest.h>

#include "robot_types/rigid_pose.h"

namespace robots::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Returns a frame whose rotation is one to 1e-6, and no better.
Isometry3d roughly(double angle, const Vector3d& axis) {
  Isometry3d frame(AngleAxisd(angle, axis.normalized()));
  frame.linear() *= 1 + 4e-7;
  return frame;
}

TEST(SurgeonView, LeavesPosesRigid) {
  SceneFrames frames;
  frames.camera = roughly(0.3, {1, 2, 3});
  frames.display = roughly(0.6, {-1, 0.5, 1});
  frames.left_master = roughly(-0.3, {0.3, 1, -1});
  frames.left_base = roughly(0.9, {1, 1, 0.2});
  for (const Isometry3d* frame :
       {&frames.camera, &frames.display, &frames.left_master, &frames.left_base}) {
    ASSERT_TRUE(isRigid(*frame));
  }
  Isometry3d goal = Isometry3d::Identity();
  goal.linear() = surgeonView(frames, Side::Left, Side::Left);
  EXPECT_TRUE(isRigid(goal));
}

}  // namespace
}  // namespace robots::test
