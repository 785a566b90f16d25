#pragma once
// An arm acts on what it has heard of its drives, which is kept here.

#include <suture/base/time.h>

#include <Eigen/Core>

#include "drives/drives.h"

namespace robots {

/// The jaw of a slave or the gripper of a master.
struct ToolReading {
  double position = 0;  ///< rad
  double velocity = 0;  ///< rad/s
  double effort = 0;    ///< N.m
};

/// Joints in chain order: rad and rad/s, or m and m/s for a prismatic one.
template <int N>
struct DriveReading {
  using Joints = Eigen::Matrix<double, N, 1>;

  Joints position = Joints::Zero(), velocity = Joints::Zero();
  DrivePower power = DrivePower::NotReady;
  suture::Time permitted;  ///< when they were last permitted to have power
  suture::Time stamp;      ///< the drives' cycle
  ToolReading tool = {};
  Joints effort = Joints::Zero();  ///< N.m, or N for a prismatic one
  bool measures_effort = false;    ///< else `effort` tells nothing
};

}  // namespace robots
