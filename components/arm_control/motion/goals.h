#pragma once
// This says which goals an arm can act on.

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "robot_types/joints.h"
#include "robot_types/pose.h"
#include "robot_types/rigid_pose.h"

namespace robots {

inline bool isPose(const PoseStamped& goal) { return goal.valid && isRigid(goal.pose); }

/// Returns none unless the list has N entries, all of which can be meant.
template <int N, class List>
std::optional<Eigen::Matrix<double, N, 1>> toJoints(const List& list) {
  if (list.size() != std::size_t{N}) return std::nullopt;
  Eigen::Matrix<double, N, 1> q = Eigen::Map<const Eigen::Matrix<double, N, 1>>(list.data());
  if (!canBeMeant(q)) return std::nullopt;
  return q;
}

}  // namespace robots
