#pragma once
// This is the difference between two poses, as one vector of position and orientation.

#include <Eigen/Geometry>

namespace robots::kinematics {

/// Returns the rotation that leads from `from` to `to`, as axis times angle (rad, at most pi) in
/// the frame in which both are given. It is exact to rounding for tiny angles, for which acos of a
/// trace is not.
inline Eigen::Vector3d rotationError(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd difference{Eigen::Quaterniond{to * from.transpose()}};
  return difference.angle() * difference.axis();
}

/// Returns the translation (m) in entries 0..2 and the rotationError (rad) in entries 3..5.
inline Eigen::Matrix<double, 6, 1> poseError(const Eigen::Isometry3d& from,
                                             const Eigen::Isometry3d& to) {
  Eigen::Matrix<double, 6, 1> error;
  error << to.translation() - from.translation(), rotationError(from.linear(), to.linear());
  return error;
}

/// This much position error, in m, weighs as much as one radian of orientation error, wherever the
/// two are compared.
constexpr double kLengthScale = 0.1;

/// Returns the weights of the squares of a poseError: 1/m^2 and 1.
inline Eigen::Matrix<double, 6, 1> poseWeights() {
  Eigen::Matrix<double, 6, 1> weights;
  weights << Eigen::Vector3d::Constant(1 / (kLengthScale * kLengthScale)), Eigen::Vector3d::Ones();
  return weights;
}

}  // namespace robots::kinematics
