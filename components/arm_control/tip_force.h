#pragma once
// What the efforts of joints come to at the tool tip.

#include <Eigen/QR>
#include <cmath>
#include <optional>

#include "kinematics/spatial_vector.h"

namespace robots {

/// The wrench that the efforts `effort` of the joints press with at the tip, along the axes of
/// `jacobian`: the one whose product with the transposed Jacobian they are, or of seven joints the
/// nearest in least squares. None beside a singularity, where a small effort stands for any force.
/// Never allocates.
template <int N>
std::optional<kinematics::SpatialVector> tipForce(const Eigen::Matrix<double, 6, N>& jacobian,
                                                  const Eigen::Matrix<double, N, 1>& effort) {
  constexpr double kLeastLever = 0.01;  // m: there 1 N.m stands for 100 N
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, N, 6>> solver(jacobian.transpose());
  if (!(std::abs(solver.matrixQR()(5, 5)) > kLeastLever)) return std::nullopt;
  return kinematics::SpatialVector(solver.solve(effort));
}

}  // namespace robots
