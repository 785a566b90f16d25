#include "arm_control/tip_force.h"

#include <Eigen/Cholesky>

namespace robots {

// A QR decomposition of the transposed Jacobian with column pivoting would do the same: the pivots
// here are the squares of its pivots. This one compiles in a third of the time.
std::optional<kinematics::SpatialVector> wrenchOf(const Eigen::Matrix<double, 6, 6>& levers,
                                                  const kinematics::SpatialVector& moment) {
  constexpr double kLeastLever = 0.01;  // m: there 1 N.m stands for 100 N
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(levers);
  if (!(solver.vectorD()[5] > kLeastLever * kLeastLever)) return std::nullopt;
  return kinematics::SpatialVector(solver.solve(moment));
}

}  // namespace robots
