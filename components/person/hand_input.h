#pragma once

#include <Eigen/Core>
#include <optional>

namespace robots {

/// Holds what a person asks of the hand that holds a master, in the directions of the master's
/// reference frame.
struct HandInput {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
  /// The gripper shall be open this far, from 0 to 1; there is no value until the person has said
  /// so.
  std::optional<double> opening;

  bool isAtRest() const { return velocity.isZero(0) && angular_velocity.isZero(0); }
};

}  // namespace robots
