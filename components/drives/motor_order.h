#pragma once
// This says what motors do beside what holds their joints at a set-point.

#include <Eigen/Core>

namespace robots {

/// By default all joints are held, and the motors carry the arm's weight.
template <int N>
struct MotorOrder {
  /// In N.m, or N for a prismatic joint: is added to what the motors give otherwise.
  Eigen::Matrix<double, N, 1> effort = Eigen::Matrix<double, N, 1>::Zero();
  /// Says which joints no set-point holds.
  Eigen::Array<bool, N, 1> released = Eigen::Array<bool, N, 1>::Constant(false);
  bool compensation = true;  ///< of the arm's weight
};

}  // namespace robots
