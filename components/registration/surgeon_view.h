#pragma once

#include <Eigen/Geometry>

#include "registration/registration.h"
#include "robot_types/side.h"

namespace robots {

/// From directions in the base frame of a master to those in the base frame of a slave that look
/// the same: what is to the right at the display is to the right in the camera's picture.
inline Eigen::Matrix3d surgeonView(const SceneFrames& frames, Side master, Side slave) {
  const auto& masterBase = master == Side::Left ? frames.left_master : frames.right_master;
  const auto& slaveBase = slave == Side::Left ? frames.left_base : frames.right_base;
  return slaveBase.linear().transpose() * frames.camera.linear() *
         frames.display.linear().transpose() * masterBase.linear();
}

}  // namespace robots
