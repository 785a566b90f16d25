#pragma once

#include <Eigen/Geometry>

#include "registration/registration.h"
#include "robot_types/side.h"

namespace robots {

/// Rotates directions in the scene to those at the console that look the same: what is to the right
/// in the camera's picture is to the right at the display.
inline Eigen::Matrix3d sceneAtConsole(const SceneFrames& frames) {
  return frames.display.linear() * frames.camera.linear().transpose();
}

/// Rotates directions in the reference frame of a master to those in that of a slave that look the
/// same.
inline Eigen::Matrix3d surgeonView(const SceneFrames& frames, Side master, Side slave) {
  const auto& masterBase = master == Side::Left ? frames.left_master : frames.right_master;
  const auto& slaveBase = slave == Side::Left ? frames.left_base : frames.right_base;
  return slaveBase.linear().transpose() * sceneAtConsole(frames).transpose() * masterBase.linear();
}

}  // namespace robots
