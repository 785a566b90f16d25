#pragma once
// This computes the wrench at the tool tip from the efforts of the joints.

#include <optional>

#include "kinematics/spatial_vector.h"

namespace robots {

/// Returns the wrench at the tip that solves `levers` * wrench = `moment`: `levers` is J * J^T of
/// the Jacobian J, and `moment` is J * effort. Returns none beside a singularity, where a small
/// effort stands for any force. Never allocates.
std::optional<kinematics::SpatialVector> wrenchOf(const Eigen::Matrix<double, 6, 6>& levers,
                                                  const kinematics::SpatialVector& moment);

/// Returns the wrench with which the efforts `effort` of the joints press at the tip, along the
/// axes of `jacobian`: the wrench whose product with the transposed Jacobian is the efforts, or for
/// seven joints the nearest in least squares. Returns none beside a singularity. Never allocates.
template <int N>
std::optional<kinematics::SpatialVector> tipForce(const Eigen::Matrix<double, 6, N>& jacobian,
                                                  const Eigen::Matrix<double, N, 1>& effort) {
  return wrenchOf(jacobian * jacobian.transpose(), jacobian * effort);
}

}  // namespace robots
