#pragma once
// This says which goals an arm can act on.

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>

#include "robot_types/joints.h"
#include "robot_types/pose.h"

namespace robots {

/// Returns true if the pose is finite, and its rotation is one to 1e-6.
inline bool isRigid(const Eigen::Isometry3d& pose) {
  constexpr double kRotationTolerance = 1e-6;
  const Eigen::Matrix3d rotation = pose.linear();
  return pose.matrix().allFinite() &&
         (rotation * rotation.transpose()).isIdentity(kRotationTolerance) &&
         rotation.determinant() > 0;
}

inline bool isPose(const PoseStamped& goal) { return goal.valid && isRigid(goal.pose); }

/// Returns none unless the list has N entries, all finite.
template <int N, class List>
std::optional<Eigen::Matrix<double, N, 1>> toJoints(const List& list) {
  if (list.size() != std::size_t{N}) return std::nullopt;
  Eigen::Matrix<double, N, 1> q = Eigen::Map<const Eigen::Matrix<double, N, 1>>(list.data());
  if (!q.allFinite()) return std::nullopt;
  return q;
}

}  // namespace robots
