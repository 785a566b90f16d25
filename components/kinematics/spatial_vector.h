#pragma once
// These are twists and wrenches as six numbers.

#include <Eigen/Core>

namespace robots::kinematics {

/// Holds the linear part (m/s, N) before the angular one (rad/s, N.m), along the axes of one frame.
using SpatialVector = Eigen::Matrix<double, 6, 1>;

/// Returns the same twist or wrench, of the same point, along the axes to which `rotation` leads.
template <class Rotation>
SpatialVector rotated(const Eigen::MatrixBase<Rotation>& rotation, const SpatialVector& vector) {
  SpatialVector result;
  result << rotation * vector.head<3>(), rotation * vector.tail<3>();
  return result;
}

}  // namespace robots::kinematics
