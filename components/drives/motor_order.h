#pragma once
// This says what motors do beside what holds their joints at a set-point.

#include <Eigen/Core>

namespace robots {

/// By default all joints are held, and the motors carry the arm's weight.
template <int N>
struct MotorOrder {
  /// The motors add this to what they give otherwise: in N.m, or in N for a prismatic joint.
  Eigen::Matrix<double, N, 1> effort = Eigen::Matrix<double, N, 1>::Zero();
  /// No set-point holds the joints for which this is true.
  Eigen::Array<bool, N, 1> released = Eigen::Array<bool, N, 1>::Constant(false);
  bool compensation = true;  ///< the motors carry the arm's weight
};

}  // namespace robots
