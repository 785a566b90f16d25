#pragma once
// This tells a pose from a matrix that is none.

#include <Eigen/Geometry>

namespace robots {

/// No number of a goal or a pose can mean more than this, in SI units, and it is so little that no
/// product of several with the lengths of an arm overflows.
constexpr double kMostMeant = 1e9;

/// Any thread. Returns true if all entries of the vector can be meant; none that is not finite can.
template <class Derived>
bool canBeMeant(const Eigen::MatrixBase<Derived>& vector) {
  return (vector.array().abs() <= kMostMeant).all();
}

/// Any thread. Returns true if the pose can be meant, and its rotation is one to 1e-6.
inline bool isRigid(const Eigen::Isometry3d& pose) {
  constexpr double kRotationTolerance = 1e-6;
  const Eigen::Matrix3d rotation = pose.linear();
  return canBeMeant(pose.matrix()) &&
         (rotation * rotation.transpose()).isIdentity(kRotationTolerance) &&
         rotation.determinant() > 0;
}

/// Any thread. Returns the rotation that is nearest to one to 1e-6.
inline Eigen::Matrix3d exact(const Eigen::Matrix3d& rotation) {
  return Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
}

/// Any thread. Returns a rigid pose with the nearest rotation. Who keeps a frame makes it exact,
/// because others take its transpose for its inverse and multiply several, for which the six digits
/// that people write are not enough.
inline Eigen::Isometry3d exact(const Eigen::Isometry3d& pose) {
  Eigen::Isometry3d result = pose;
  result.linear() = exact(Eigen::Matrix3d(pose.linear()));
  return result;
}

}  // namespace robots
