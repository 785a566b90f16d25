#pragma once
// The wrench at the tool tip follows from the efforts of the joints.

#include <optional>

#include "kinematics/spatial_vector.h"

namespace robots {

/// The wrench at the tip that solves `levers` * wrench = `moment`: `levers` is J * J^T of the
/// Jacobian J, and `moment` is J * effort. None beside a singularity, where a small effort stands
/// for any force. Never allocates.
std::optional<kinematics::SpatialVector> wrenchOf(const Eigen::Matrix<double, 6, 6>& levers,
                                                  const kinematics::SpatialVector& moment);

/// The wrench that the efforts `effort` of the joints press with at the tip, along the axes of
/// `jacobian`: the one whose product with the transposed Jacobian they are, or of seven joints the
/// nearest in least squares. None beside a singularity. Never allocates.
template <int N>
std::optional<kinematics::SpatialVector> tipForce(const Eigen::Matrix<double, 6, N>& jacobian,
                                                  const Eigen::Matrix<double, N, 1>& effort) {
  return wrenchOf(jacobian * jacobian.transpose(), jacobian * effort);
}

}  // namespace robots
