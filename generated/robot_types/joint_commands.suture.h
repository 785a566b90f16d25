// Written by suturec from robot_types/joint_commands.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/joint_commands.h"

namespace robots {

/// Corresponds to cisst's prmPositionJointGet.
struct JointPositionSlot {
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<std::int64_t, 8> stamps;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const JointPosition& value, JointPositionSlot& slot);
void load(const JointPositionSlot& slot, JointPosition& value);
void reserve(const JointPositionSlot*, JointPosition& value);
void shiftStamps(JointPositionSlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmPositionJointSet.
struct JointPositionGoalSlot {
  suture::BoundedList<double, 8> goal;          // rad
  suture::BoundedList<double, 8> velocity;      // rad/s
  suture::BoundedList<double, 8> acceleration;  // rad/s2
  std::int64_t time_limit;                      // std::chrono::nanoseconds, ns
  std::uint8_t is_coordinated;                  // bool
  std::int64_t stamp;                           // suture::Time, ns
};

bool store(const JointPositionGoal& value, JointPositionGoalSlot& slot);
void load(const JointPositionGoalSlot& slot, JointPositionGoal& value);
void reserve(const JointPositionGoalSlot*, JointPositionGoal& value);
void shiftStamps(JointPositionGoalSlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmVelocityJointGet.
struct JointVelocitySlot {
  suture::BoundedList<double, 8> velocity;  // rad/s
  std::int64_t stamp;                       // suture::Time, ns
  std::uint8_t valid;                       // bool
};

bool store(const JointVelocity& value, JointVelocitySlot& slot);
void load(const JointVelocitySlot& slot, JointVelocity& value);
void reserve(const JointVelocitySlot*, JointVelocity& value);
void shiftStamps(JointVelocitySlot& slot, suture::Duration shift);

/// A JointVelocityGoal is the goal of CRTK's servo_jv; corresponds to cisst's prmVelocityJointSet.
struct JointVelocityGoalSlot {
  suture::BoundedList<double, 8> goal;          // rad/s
  suture::BoundedList<double, 8> acceleration;  // rad/s2
  suture::BoundedList<double, 8> deceleration;  // rad/s2
  suture::BoundedList<double, 8> guard;         // rad
  suture::BoundedList<std::uint8_t, 8> mask;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const JointVelocityGoal& value, JointVelocityGoalSlot& slot);
void load(const JointVelocityGoalSlot& slot, JointVelocityGoal& value);
void reserve(const JointVelocityGoalSlot*, JointVelocityGoal& value);
void shiftStamps(JointVelocityGoalSlot& slot, suture::Duration shift);

/// A JointEffortGoal is the goal of CRTK's servo_jf; corresponds to cisst's prmForceTorqueJointSet.
struct JointEffortGoalSlot {
  suture::BoundedList<double, 8> effort;  // N.m
  suture::BoundedList<std::uint8_t, 8> mask;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const JointEffortGoal& value, JointEffortGoalSlot& slot);
void load(const JointEffortGoalSlot& slot, JointEffortGoal& value);
void reserve(const JointEffortGoalSlot*, JointEffortGoal& value);
void shiftStamps(JointEffortGoalSlot& slot, suture::Duration shift);

/// Says what the joints are and what they may do, for CRTK's configuration_js. Corresponds to
/// cisst's prmConfigurationJoint.
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

bool store(const JointConfiguration& value, JointConfigurationSlot& slot);
void load(const JointConfigurationSlot& slot, JointConfiguration& value);
void reserve(const JointConfigurationSlot*, JointConfiguration& value);

/// A ServoJoint has position, velocity and effort in one servo command; corresponds to cisst's
/// prmServoJoint.
struct ServoJointSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<std::uint16_t, 8> mode;
  suture::BoundedList<double, 8> position;  // rad
  suture::BoundedList<double, 8> velocity;  // rad/s
  suture::BoundedList<double, 8> effort;    // N.m
  suture::BoundedList<double, 64> position_projection;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const ServoJoint& value, ServoJointSlot& slot);
void load(const ServoJointSlot& slot, ServoJoint& value);
void reserve(const ServoJointSlot*, ServoJoint& value);
void shiftStamps(ServoJointSlot& slot, suture::Duration shift);

/// Turns actuators into joints and back, joints x actuators, row-major.
/// Corresponds to cisst's prmActuatorJointCoupling.
struct ActuatorJointCouplingSlot {
  std::uint32_t joints;
  std::uint32_t actuators;
  suture::BoundedList<double, 64> actuator_to_joint_position;
  suture::BoundedList<double, 64> joint_to_actuator_position;
  suture::BoundedList<double, 64> actuator_to_joint_effort;
  suture::BoundedList<double, 64> joint_to_actuator_effort;
};

bool store(const ActuatorJointCoupling& value, ActuatorJointCouplingSlot& slot);
void load(const ActuatorJointCouplingSlot& slot, ActuatorJointCoupling& value);
void reserve(const ActuatorJointCouplingSlot*, ActuatorJointCoupling& value);

/// A Jacobian is 6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint
/// velocity.
struct JacobianSlot {
  std::uint32_t joints;
  suture::BoundedList<double, 48> coefficients;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const Jacobian& value, JacobianSlot& slot);
void load(const JacobianSlot& slot, Jacobian& value);
void reserve(const JacobianSlot*, Jacobian& value);
void shiftStamps(JacobianSlot& slot, suture::Duration shift);

bool isKnownJointType(std::uint8_t slot);
bool isValid(const JointPositionSlot& slot, suture::FieldPath* path);
bool isValid(const JointPositionGoalSlot& slot, suture::FieldPath* path);
bool isValid(const JointVelocitySlot& slot, suture::FieldPath* path);
bool isValid(const JointVelocityGoalSlot& slot, suture::FieldPath* path);
bool isValid(const JointEffortGoalSlot& slot, suture::FieldPath* path);
bool isValid(const JointConfigurationSlot& slot, suture::FieldPath* path);
bool isValid(const ServoJointSlot& slot, suture::FieldPath* path);
bool isValid(const ActuatorJointCouplingSlot& slot, suture::FieldPath* path);
bool isValid(const JacobianSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::JointPosition& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointPosition& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointPositionGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointPositionGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointVelocity& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointVelocity& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointVelocityGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointVelocityGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointEffortGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointEffortGoal& value);

template <>
Result<std::vector<std::byte>> encode(const robots::JointConfiguration& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointConfiguration& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ServoJoint& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ServoJoint& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ActuatorJointCoupling& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ActuatorJointCoupling& value);

template <>
Result<std::vector<std::byte>> encode(const robots::Jacobian& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Jacobian& value);

}  // namespace suture
