// Written by suturec from robot_types/joint_commands.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/joint_commands.h"

namespace robots {

/// prmPositionJointGet.
struct JointPositionSlot {
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<std::int64_t, 8> stamps;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const JointPosition& value, JointPositionSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.stamps, slot.stamps);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const JointPositionSlot& slot, JointPosition& value) {
  using suture::load;
  load(slot.position, value.position);
  load(slot.stamps, value.stamps);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmPositionJointSet.
struct JointPositionGoalSlot {
  suture::BoundedList<double, 8> goal;          // rad
  suture::BoundedList<double, 8> velocity;      // rad/s
  suture::BoundedList<double, 8> acceleration;  // rad/s2
  std::int64_t time_limit;                      // std::chrono::nanoseconds, ns
  std::uint8_t is_coordinated;                  // bool
  std::int64_t stamp;                           // suture::Time, ns
};

inline bool store(const JointPositionGoal& value, JointPositionGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.acceleration, slot.acceleration);
  fits &= store(value.time_limit, slot.time_limit);
  fits &= store(value.is_coordinated, slot.is_coordinated);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const JointPositionGoalSlot& slot, JointPositionGoal& value) {
  using suture::load;
  load(slot.goal, value.goal);
  load(slot.velocity, value.velocity);
  load(slot.acceleration, value.acceleration);
  load(slot.time_limit, value.time_limit);
  load(slot.is_coordinated, value.is_coordinated);
  load(slot.stamp, value.stamp);
}

/// prmVelocityJointGet.
struct JointVelocitySlot {
  suture::BoundedList<double, 8> velocity;  // rad/s
  std::int64_t stamp;                       // suture::Time, ns
  std::uint8_t valid;                       // bool
};

inline bool store(const JointVelocity& value, JointVelocitySlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const JointVelocitySlot& slot, JointVelocity& value) {
  using suture::load;
  load(slot.velocity, value.velocity);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// CRTK's servo_jv: prmVelocityJointSet.
struct JointVelocityGoalSlot {
  suture::BoundedList<double, 8> goal;          // rad/s
  suture::BoundedList<double, 8> acceleration;  // rad/s2
  suture::BoundedList<double, 8> deceleration;  // rad/s2
  suture::BoundedList<double, 8> guard;         // rad
  suture::BoundedList<std::uint8_t, 8> mask;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const JointVelocityGoal& value, JointVelocityGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.acceleration, slot.acceleration);
  fits &= store(value.deceleration, slot.deceleration);
  fits &= store(value.guard, slot.guard);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const JointVelocityGoalSlot& slot, JointVelocityGoal& value) {
  using suture::load;
  load(slot.goal, value.goal);
  load(slot.acceleration, value.acceleration);
  load(slot.deceleration, value.deceleration);
  load(slot.guard, value.guard);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

/// CRTK's servo_jf: prmForceTorqueJointSet.
struct JointEffortGoalSlot {
  suture::BoundedList<double, 8> effort;  // N.m
  suture::BoundedList<std::uint8_t, 8> mask;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const JointEffortGoal& value, JointEffortGoalSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.effort, slot.effort);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const JointEffortGoalSlot& slot, JointEffortGoal& value) {
  using suture::load;
  load(slot.effort, value.effort);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

/// What the joints are and may do: CRTK's configuration_js. prmConfigurationJoint.
struct JointConfigurationSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<std::uint8_t, 8> type;
  suture::BoundedList<double, 8> position_min;      // rad
  suture::BoundedList<double, 8> position_max;      // rad
  suture::BoundedList<double, 8> velocity_min;      // rad/s
  suture::BoundedList<double, 8> velocity_max;      // rad/s
  suture::BoundedList<double, 8> acceleration_min;  // rad/s2
  suture::BoundedList<double, 8> acceleration_max;  // rad/s2
  suture::BoundedList<double, 8> effort_min;        // N.m
  suture::BoundedList<double, 8> effort_max;        // N.m
  std::uint8_t valid;                               // bool
};

inline bool store(const JointConfiguration& value, JointConfigurationSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.type, slot.type);
  fits &= store(value.position_min, slot.position_min);
  fits &= store(value.position_max, slot.position_max);
  fits &= store(value.velocity_min, slot.velocity_min);
  fits &= store(value.velocity_max, slot.velocity_max);
  fits &= store(value.acceleration_min, slot.acceleration_min);
  fits &= store(value.acceleration_max, slot.acceleration_max);
  fits &= store(value.effort_min, slot.effort_min);
  fits &= store(value.effort_max, slot.effort_max);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const JointConfigurationSlot& slot, JointConfiguration& value) {
  using suture::load;
  load(slot.name, value.name);
  load(slot.type, value.type);
  load(slot.position_min, value.position_min);
  load(slot.position_max, value.position_max);
  load(slot.velocity_min, value.velocity_min);
  load(slot.velocity_max, value.velocity_max);
  load(slot.acceleration_min, value.acceleration_min);
  load(slot.acceleration_max, value.acceleration_max);
  load(slot.effort_min, value.effort_min);
  load(slot.effort_max, value.effort_max);
  load(slot.valid, value.valid);
}

/// Position, velocity and effort in one servo command: prmServoJoint.
struct ServoJointSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<std::uint16_t, 8> mode;
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<double, 8> velocity;  // rad/s
  suture::BoundedList<double, 8> effort;    // N.m
  suture::BoundedList<double, 64> position_projection;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const ServoJoint& value, ServoJointSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.mode, slot.mode);
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.effort, slot.effort);
  fits &= store(value.position_projection, slot.position_projection);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const ServoJointSlot& slot, ServoJoint& value) {
  using suture::load;
  load(slot.name, value.name);
  load(slot.mode, value.mode);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
  load(slot.position_projection, value.position_projection);
  load(slot.stamp, value.stamp);
}

/// What turns actuators into joints and back, joints x actuators, row-major:
/// prmActuatorJointCoupling.
struct ActuatorJointCouplingSlot {
  std::uint32_t joints;
  std::uint32_t actuators;
  suture::BoundedList<double, 64> actuator_to_joint_position;
  suture::BoundedList<double, 64> joint_to_actuator_position;
  suture::BoundedList<double, 64> actuator_to_joint_effort;
  suture::BoundedList<double, 64> joint_to_actuator_effort;
};

inline bool store(const ActuatorJointCoupling& value, ActuatorJointCouplingSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.actuators, slot.actuators);
  fits &= store(value.actuator_to_joint_position, slot.actuator_to_joint_position);
  fits &= store(value.joint_to_actuator_position, slot.joint_to_actuator_position);
  fits &= store(value.actuator_to_joint_effort, slot.actuator_to_joint_effort);
  fits &= store(value.joint_to_actuator_effort, slot.joint_to_actuator_effort);
  return fits;
}

inline void load(const ActuatorJointCouplingSlot& slot, ActuatorJointCoupling& value) {
  using suture::load;
  load(slot.joints, value.joints);
  load(slot.actuators, value.actuators);
  load(slot.actuator_to_joint_position, value.actuator_to_joint_position);
  load(slot.joint_to_actuator_position, value.joint_to_actuator_position);
  load(slot.actuator_to_joint_effort, value.actuator_to_joint_effort);
  load(slot.joint_to_actuator_effort, value.joint_to_actuator_effort);
}

/// 6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint velocity.
struct JacobianSlot {
  std::uint32_t joints;
  suture::BoundedList<double, 48> coefficients;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const Jacobian& value, JacobianSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.coefficients, slot.coefficients);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const JacobianSlot& slot, Jacobian& value) {
  using suture::load;
  load(slot.joints, value.joints);
  load(slot.coefficients, value.coefficients);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

}  // namespace robots
