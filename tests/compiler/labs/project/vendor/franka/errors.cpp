// This is what stands in libfranka's library, not in its headers.
#include "errors.h"

#include <algorithm>

namespace franka {

Errors::Errors() : Errors(std::array<bool, 41>{}) {}

Errors::Errors(const Errors& other) : Errors(other.errors_) {}

Errors& Errors::operator=(Errors other) {
  std::swap(errors_, other.errors_);
  return *this;
}

Errors::Errors(const std::array<bool, 41>& errors)
    : errors_(errors),
      joint_position_limits_violation(errors_[0]),
      cartesian_position_limits_violation(errors_[1]),
      self_collision_avoidance_violation(errors_[2]),
      joint_velocity_violation(errors_[3]),
      cartesian_velocity_violation(errors_[4]),
      force_control_safety_violation(errors_[5]),
      joint_reflex(errors_[6]),
      cartesian_reflex(errors_[7]),
      max_goal_pose_deviation_violation(errors_[8]),
      max_path_pose_deviation_violation(errors_[9]),
      cartesian_velocity_profile_safety_violation(errors_[10]),
      joint_position_motion_generator_start_pose_invalid(errors_[11]),
      joint_motion_generator_position_limits_violation(errors_[12]),
      joint_motion_generator_velocity_limits_violation(errors_[13]),
      joint_motion_generator_velocity_discontinuity(errors_[14]),
      joint_motion_generator_acceleration_discontinuity(errors_[15]),
      cartesian_position_motion_generator_start_pose_invalid(errors_[16]),
      cartesian_motion_generator_elbow_limit_violation(errors_[17]),
      cartesian_motion_generator_velocity_limits_violation(errors_[18]),
      cartesian_motion_generator_velocity_discontinuity(errors_[19]),
      cartesian_motion_generator_acceleration_discontinuity(errors_[20]),
      cartesian_motion_generator_elbow_sign_inconsistent(errors_[21]),
      cartesian_motion_generator_start_elbow_invalid(errors_[22]),
      cartesian_motion_generator_joint_position_limits_violation(errors_[23]),
      cartesian_motion_generator_joint_velocity_limits_violation(errors_[24]),
      cartesian_motion_generator_joint_velocity_discontinuity(errors_[25]),
      cartesian_motion_generator_joint_acceleration_discontinuity(errors_[26]),
      cartesian_position_motion_generator_invalid_frame(errors_[27]),
      force_controller_desired_force_tolerance_violation(errors_[28]),
      controller_torque_discontinuity(errors_[29]),
      start_elbow_sign_inconsistent(errors_[30]),
      communication_constraints_violation(errors_[31]),
      power_limit_violation(errors_[32]),
      joint_p2p_insufficient_torque_for_planning(errors_[33]),
      tau_j_range_violation(errors_[34]),
      instability_detected(errors_[35]),
      joint_move_in_wrong_direction(errors_[36]),
      cartesian_spline_motion_generator_violation(errors_[37]),
      joint_via_motion_generator_planning_joint_limit_violation(errors_[38]),
      base_acceleration_initialization_timeout(errors_[39]),
      base_acceleration_invalid_reading(errors_[40]) {}

Errors::operator bool() const noexcept {
  return std::find(errors_.begin(), errors_.end(), true) != errors_.end();
}

}  // namespace franka
