#pragma once

#include <Eigen/Geometry>

#include "registration/registration.h"
#include "robot_types/rigid_pose.h"
#include "robot_types/side.h"

namespace robots {

/// Rotates directions in the scene to those at the console that look the same: what is to the right
/// in the camera's picture is to the right at the display.
inline Eigen::Matrix3d sceneAtConsole(const SceneFrames& frames) {
  return frames.display.linear() * frames.camera.linear().transpose();
}

/// Rotates directions in the reference frame of a master to those in that of a slave that look the
/// same. A registration may have rotations of six digits; the product of four of them is exact
/// here, because an arm refuses a goal that is none.
inline Eigen::Matrix3d surgeonView(const SceneFrames& frames, Side master, Side slave) {
  const auto& masterBase = master == Side::Left ? frames.left_master : frames.right_master;
  const auto& slaveBase = slave == Side::Left ? frames.left_base : frames.right_base;
  return exact(Eigen::Matrix3d(slaveBase.linear().transpose() * sceneAtConsole(frames).transpose() *
                               masterBase.linear()));
}

}  // namespace robots
