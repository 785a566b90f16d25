// Written by suturec from robot_types/cartesian.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/cartesian.h"

namespace robots {

/// A velocity: CRTK's measured_cv. The cisst libraries' prmVelocityCartesianGet.
struct TwistSlot {
  std::array<double, 3> linear;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular;  // Eigen::Vector3d, rad/s
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const Twist& value, TwistSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.linear, slot.linear);
  fits &= store(value.angular, slot.angular);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const TwistSlot& slot, Twist& value) {
  using suture::load;
  load(slot.linear, value.linear);
  load(slot.angular, value.angular);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// A velocity to follow: CRTK's servo_cv. prmVelocityCartesianSet.
struct TwistGoalSlot {
  std::array<double, 3> linear;                // Eigen::Vector3d, m/s
  std::array<double, 3> angular;               // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;   // Eigen::Vector3d, m/s2
  std::array<double, 3> angular_acceleration;  // Eigen::Vector3d, rad/s2
  std::array<std::uint8_t, 6> mask;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const TwistGoal& value, TwistGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.linear, slot.linear);
  fits &= store(value.angular, slot.angular);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const TwistGoalSlot& slot, TwistGoal& value) {
  using suture::load;
  load(slot.linear, value.linear);
  load(slot.angular, value.angular);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

/// Force and torque at the tool tip: CRTK's measured_cf. prmForceCartesianGet.
struct WrenchSlot {
  std::array<double, 3> force;   // Eigen::Vector3d, N
  std::array<double, 3> torque;  // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> mask;
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const Wrench& value, WrenchSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const WrenchSlot& slot, Wrench& value) {
  using suture::load;
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.mask, value.mask);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// Force and torque to apply: CRTK's servo_cf. prmForceCartesianSet.
struct WrenchGoalSlot {
  std::array<double, 3> force;   // Eigen::Vector3d, N
  std::array<double, 3> torque;  // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> mask;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const WrenchGoal& value, WrenchGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const WrenchGoalSlot& slot, WrenchGoal& value) {
  using suture::load;
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

/// Pose, velocity and force of one instant: CRTK's measured_cs. prmStateCartesian.
struct CartesianStateSlot {
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::array<double, 12> position;         // Eigen::Isometry3d, m
  std::uint8_t position_is_valid;          // bool
  std::array<double, 3> linear_velocity;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;  // Eigen::Vector3d, rad/s
  std::uint8_t velocity_is_valid;          // bool
  std::array<double, 3> force;             // Eigen::Vector3d, N
  std::array<double, 3> torque;            // Eigen::Vector3d, N.m
  std::uint8_t force_is_valid;             // bool
  std::int64_t stamp;                      // suture::Time, ns
};

inline bool store(const CartesianState& value, CartesianStateSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.position, slot.position);
  fits &= store(value.position_is_valid, slot.position_is_valid);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.velocity_is_valid, slot.velocity_is_valid);
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.force_is_valid, slot.force_is_valid);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const CartesianStateSlot& slot, CartesianState& value) {
  using suture::load;
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.position, value.position);
  load(slot.position_is_valid, value.position_is_valid);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.velocity_is_valid, value.velocity_is_valid);
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.force_is_valid, value.force_is_valid);
  load(slot.stamp, value.stamp);
}

/// A pose to reach, with how to get there: prmPositionCartesianSet.
struct CartesianGoalSlot {
  std::array<double, 12> goal;                 // Eigen::Isometry3d, m
  std::array<double, 3> linear_velocity;       // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;      // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;   // Eigen::Vector3d, m/s2
  std::array<double, 3> angular_acceleration;  // Eigen::Vector3d, rad/s2
  std::array<std::uint8_t, 2> mask;
  suture::BoundedText<15> moving_frame;
  suture::BoundedText<15> reference_frame;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const CartesianGoal& value, CartesianGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const CartesianGoalSlot& slot, CartesianGoal& value) {
  using suture::load;
  load(slot.goal, value.goal);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.mask, value.mask);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// Position, velocity and effort in one servo command: prmServoCartesian.
struct ServoCartesianSlot {
  std::array<double, 12> task_frame;       // Eigen::Isometry3d, m
  std::array<double, 12> position;         // Eigen::Isometry3d, m
  std::array<double, 3> linear_velocity;   // Eigen::Vector3d, m/s
  std::array<double, 3> angular_velocity;  // Eigen::Vector3d, rad/s
  std::array<double, 3> force;             // Eigen::Vector3d, N
  std::array<double, 3> torque;            // Eigen::Vector3d, N.m
  std::array<std::uint8_t, 6> axis_mode;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const ServoCartesian& value, ServoCartesianSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.task_frame, slot.task_frame);
  fits &= store(value.position, slot.position);
  fits &= store(value.linear_velocity, slot.linear_velocity);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  fits &= store(value.axis_mode, slot.axis_mode);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const ServoCartesianSlot& slot, ServoCartesian& value) {
  using suture::load;
  load(slot.task_frame, value.task_frame);
  load(slot.position, value.position);
  load(slot.linear_velocity, value.linear_velocity);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.force, value.force);
  load(slot.torque, value.torque);
  load(slot.axis_mode, value.axis_mode);
  load(slot.stamp, value.stamp);
}

/// How stiffly one side of an axis holds: force = p * distance + d * speed + bias beyond the
/// deadband.
struct HalfPlaneGainsSlot {
  std::array<double, 3> p;         // Eigen::Vector3d, N/m
  std::array<double, 3> d;         // Eigen::Vector3d, N.s/m
  std::array<double, 3> bias;      // Eigen::Vector3d, N
  std::array<double, 3> deadband;  // Eigen::Vector3d, m
};

inline bool store(const HalfPlaneGains& value, HalfPlaneGainsSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.d, slot.d);
  fits &= store(value.bias, slot.bias);
  fits &= store(value.deadband, slot.deadband);
  return fits;
}

inline void load(const HalfPlaneGainsSlot& slot, HalfPlaneGains& value) {
  using suture::load;
  load(slot.p, value.p);
  load(slot.d, value.d);
  load(slot.bias, value.bias);
  load(slot.deadband, value.deadband);
}

/// The same about an axis.
struct AngularHalfPlaneGainsSlot {
  std::array<double, 3> p;         // Eigen::Vector3d, N.m/rad
  std::array<double, 3> d;         // Eigen::Vector3d, N.m.s/rad
  std::array<double, 3> bias;      // Eigen::Vector3d, N.m
  std::array<double, 3> deadband;  // Eigen::Vector3d, rad
};

inline bool store(const AngularHalfPlaneGains& value, AngularHalfPlaneGainsSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.d, slot.d);
  fits &= store(value.bias, slot.bias);
  fits &= store(value.deadband, slot.deadband);
  return fits;
}

inline void load(const AngularHalfPlaneGainsSlot& slot, AngularHalfPlaneGains& value) {
  using suture::load;
  load(slot.p, value.p);
  load(slot.d, value.d);
  load(slot.bias, value.bias);
  load(slot.deadband, value.deadband);
}

/// A spring that holds the tool tip, per axis and side: prmCartesianImpedance.
struct CartesianImpedanceSlot {
  std::array<double, 9> force_orientation;   // Eigen::Matrix3d
  std::array<double, 3> force_position;      // Eigen::Vector3d, m
  std::array<double, 9> torque_orientation;  // Eigen::Matrix3d
  HalfPlaneGainsSlot position_positive;
  HalfPlaneGainsSlot position_negative;
  AngularHalfPlaneGainsSlot orientation_positive;
  AngularHalfPlaneGainsSlot orientation_negative;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const CartesianImpedance& value, CartesianImpedanceSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.force_orientation, slot.force_orientation);
  fits &= store(value.force_position, slot.force_position);
  fits &= store(value.torque_orientation, slot.torque_orientation);
  fits &= store(value.position_positive, slot.position_positive);
  fits &= store(value.position_negative, slot.position_negative);
  fits &= store(value.orientation_positive, slot.orientation_positive);
  fits &= store(value.orientation_negative, slot.orientation_negative);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const CartesianImpedanceSlot& slot, CartesianImpedance& value) {
  using suture::load;
  load(slot.force_orientation, value.force_orientation);
  load(slot.force_position, value.force_position);
  load(slot.torque_orientation, value.torque_orientation);
  load(slot.position_positive, value.position_positive);
  load(slot.position_negative, value.position_negative);
  load(slot.orientation_positive, value.orientation_positive);
  load(slot.orientation_negative, value.orientation_negative);
  load(slot.stamp, value.stamp);
}

}  // namespace robots
