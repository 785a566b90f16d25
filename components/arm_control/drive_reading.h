#pragma once
// This is what an arm has heard of its drives, on which it acts.

#include <suture/base/time.h>

#include <Eigen/Core>

#include "drives/drives.h"

namespace robots {

/// A ToolReading is a measurement of the jaw of a slave or the gripper of a master.
struct ToolReading {
  double position = 0;  ///< rad
  double velocity = 0;  ///< rad/s
  double effort = 0;    ///< N.m
};

/// Holds the joints in the order of the chain: rad and rad/s, or m and m/s for a prismatic one.
template <int N>
struct DriveReading {
  using Joints = Eigen::Matrix<double, N, 1>;

  Joints position = Joints::Zero(), velocity = Joints::Zero();
  DrivePower power = DrivePower::NotReady;
  suture::Time permitted;  ///< when they were last permitted to have power
  suture::Time stamp;      ///< the drives' cycle
  ToolReading tool = {};
  Joints effort = Joints::Zero();  ///< N.m, or N for a prismatic one
  bool measures_effort = false;    ///< if not, `effort` has no meaning
  bool controls_effort = false;    ///< if not, they follow positions only
};

}  // namespace robots
