#pragma once
// Which goals an arm can act on at all.

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "robot_types/joints.h"
#include "robot_types/pose.h"

namespace robots {

/// Finite, and its rotation is one to 1e-6.
inline bool isPose(const PoseStamped& goal) {
  constexpr double kRotationTolerance = 1e-6;
  const Eigen::Matrix3d rotation = goal.pose.linear();
  return goal.valid && goal.pose.matrix().allFinite() &&
         (rotation * rotation.transpose()).isIdentity(kRotationTolerance) &&
         rotation.determinant() > 0;
}

/// None unless it has N entries, all finite.
template <int N, class List>
std::optional<Eigen::Matrix<double, N, 1>> toJoints(const List& list) {
  if (list.size() != std::size_t{N}) return std::nullopt;
  const Eigen::Matrix<double, N, 1> q = Eigen::Map<const Eigen::Matrix<double, N, 1>>(list.data());
  if (!q.allFinite()) return std::nullopt;
  return q;
}

/// The same of a list that may be left out; `otherwise`, if it is empty.
template <int N, class List>
std::optional<Eigen::Matrix<double, N, 1>> toJointsOr(const Eigen::Matrix<double, N, 1>& otherwise,
                                                      const List& list) {
  if (list.empty()) return otherwise;
  return toJoints<N>(list);
}

/// The joints that count stay, the others are 0. None if the mask is neither empty nor has N
/// entries.
template <int N>
std::optional<Eigen::Matrix<double, N, 1>> masked(std::optional<Eigen::Matrix<double, N, 1>> joints,
                                                  const std::vector<bool>& mask) {
  if (mask.empty()) return joints;
  if (mask.size() != std::size_t{N} || !joints) return std::nullopt;
  for (int i = 0; i < N; ++i) (*joints)[i] *= mask[static_cast<std::size_t>(i)] ? 1 : 0;
  return joints;
}

}  // namespace robots
