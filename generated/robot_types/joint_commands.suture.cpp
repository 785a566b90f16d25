// Written by suturec from robot_types/joint_commands.h. Do not edit.
#include "robot_types/joint_commands.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<JointType>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(JointType::Undefined) == 0);
static_assert(static_cast<std::uint8_t>(JointType::Prismatic) == 1);
static_assert(static_cast<std::uint8_t>(JointType::Revolute) == 2);
static_assert(static_cast<std::uint8_t>(JointType::Universal) == 3);
static_assert(static_cast<std::uint8_t>(JointType::BallSocket) == 4);
static_assert(static_cast<std::uint8_t>(JointType::Inactive) == 5);
static_assert(std::is_same_v<decltype(JointPosition::position), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointPosition::stamps),
                             std::vector<std::chrono::steady_clock::time_point>>);
static_assert(std::is_same_v<decltype(JointPosition::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointPosition::valid), bool>);
static_assert(std::is_same_v<decltype(JointPositionGoal::goal), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointPositionGoal::velocity), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointPositionGoal::acceleration), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointPositionGoal::time_limit), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(JointPositionGoal::is_coordinated), bool>);
static_assert(std::is_same_v<decltype(JointPositionGoal::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointVelocity::velocity), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointVelocity::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointVelocity::valid), bool>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::goal), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::acceleration), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::deceleration), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::guard), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::mask), std::vector<bool>>);
static_assert(std::is_same_v<decltype(JointVelocityGoal::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointEffortGoal::effort), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointEffortGoal::mask), std::vector<bool>>);
static_assert(std::is_same_v<decltype(JointEffortGoal::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(JointConfiguration::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(JointConfiguration::type), std::vector<robots::JointType>>);
static_assert(std::is_same_v<decltype(JointConfiguration::position_min), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::position_max), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::velocity_min), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::velocity_max), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::acceleration_min), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::acceleration_max), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::effort_min), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::effort_max), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointConfiguration::valid), bool>);
static_assert(std::is_same_v<decltype(ServoJoint::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(ServoJoint::mode), std::vector<std::uint16_t>>);
static_assert(std::is_same_v<decltype(ServoJoint::position), std::vector<double>>);
static_assert(std::is_same_v<decltype(ServoJoint::velocity), std::vector<double>>);
static_assert(std::is_same_v<decltype(ServoJoint::effort), std::vector<double>>);
static_assert(std::is_same_v<decltype(ServoJoint::position_projection), std::vector<double>>);
static_assert(std::is_same_v<decltype(ServoJoint::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::joints), std::uint32_t>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::actuators), std::uint32_t>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::actuator_to_joint_position),
                             std::vector<double>>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::joint_to_actuator_position),
                             std::vector<double>>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::actuator_to_joint_effort),
                             std::vector<double>>);
static_assert(std::is_same_v<decltype(ActuatorJointCoupling::joint_to_actuator_effort),
                             std::vector<double>>);
static_assert(std::is_same_v<decltype(Jacobian::joints), std::uint32_t>);
static_assert(std::is_same_v<decltype(Jacobian::coefficients), std::vector<double>>);
static_assert(std::is_same_v<decltype(Jacobian::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(Jacobian::valid), bool>);

}  // namespace

bool store(const JointPosition& value, JointPositionSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.stamps, slot.stamps);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const JointPositionSlot& slot, JointPosition& value) {
  load(slot.position, value.position);
  load(slot.stamps, value.stamps);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const JointPositionSlot*, JointPosition& value) {
  suture::reserveFor<decltype(JointPositionSlot::position)>(value.position);
  suture::reserveFor<decltype(JointPositionSlot::stamps)>(value.stamps);
}

void shiftStamps(JointPositionSlot& slot, suture::Duration shift) {
  for (auto& element : suture::elementsIn(slot.stamps)) {
    element = suture::codec::shifted(element, shift);
  }
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const JointPositionGoal& value, JointPositionGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.acceleration, slot.acceleration);
  fits &= store(value.time_limit, slot.time_limit);
  fits &= store(value.is_coordinated, slot.is_coordinated);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const JointPositionGoalSlot& slot, JointPositionGoal& value) {
  load(slot.goal, value.goal);
  load(slot.velocity, value.velocity);
  load(slot.acceleration, value.acceleration);
  load(slot.time_limit, value.time_limit);
  load(slot.is_coordinated, value.is_coordinated);
  load(slot.stamp, value.stamp);
}

void reserve(const JointPositionGoalSlot*, JointPositionGoal& value) {
  suture::reserveFor<decltype(JointPositionGoalSlot::goal)>(value.goal);
  suture::reserveFor<decltype(JointPositionGoalSlot::velocity)>(value.velocity);
  suture::reserveFor<decltype(JointPositionGoalSlot::acceleration)>(value.acceleration);
}

void shiftStamps(JointPositionGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const JointVelocity& value, JointVelocitySlot& slot) {
  bool fits = true;
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const JointVelocitySlot& slot, JointVelocity& value) {
  load(slot.velocity, value.velocity);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const JointVelocitySlot*, JointVelocity& value) {
  suture::reserveFor<decltype(JointVelocitySlot::velocity)>(value.velocity);
}

void shiftStamps(JointVelocitySlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const JointVelocityGoal& value, JointVelocityGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.goal, slot.goal);
  fits &= store(value.acceleration, slot.acceleration);
  fits &= store(value.deceleration, slot.deceleration);
  fits &= store(value.guard, slot.guard);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const JointVelocityGoalSlot& slot, JointVelocityGoal& value) {
  load(slot.goal, value.goal);
  load(slot.acceleration, value.acceleration);
  load(slot.deceleration, value.deceleration);
  load(slot.guard, value.guard);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

void reserve(const JointVelocityGoalSlot*, JointVelocityGoal& value) {
  suture::reserveFor<decltype(JointVelocityGoalSlot::goal)>(value.goal);
  suture::reserveFor<decltype(JointVelocityGoalSlot::acceleration)>(value.acceleration);
  suture::reserveFor<decltype(JointVelocityGoalSlot::deceleration)>(value.deceleration);
  suture::reserveFor<decltype(JointVelocityGoalSlot::guard)>(value.guard);
  suture::reserveFor<decltype(JointVelocityGoalSlot::mask)>(value.mask);
}

void shiftStamps(JointVelocityGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const JointEffortGoal& value, JointEffortGoalSlot& slot) {
  bool fits = true;
  fits &= store(value.effort, slot.effort);
  fits &= store(value.mask, slot.mask);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

void load(const JointEffortGoalSlot& slot, JointEffortGoal& value) {
  load(slot.effort, value.effort);
  load(slot.mask, value.mask);
  load(slot.stamp, value.stamp);
}

void reserve(const JointEffortGoalSlot*, JointEffortGoal& value) {
  suture::reserveFor<decltype(JointEffortGoalSlot::effort)>(value.effort);
  suture::reserveFor<decltype(JointEffortGoalSlot::mask)>(value.mask);
}

void shiftStamps(JointEffortGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const JointConfiguration& value, JointConfigurationSlot& slot) {
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

void load(const JointConfigurationSlot& slot, JointConfiguration& value) {
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

void reserve(const JointConfigurationSlot*, JointConfiguration& value) {
  suture::reserveFor<decltype(JointConfigurationSlot::name)>(value.name);
  suture::reserveFor<decltype(JointConfigurationSlot::type)>(value.type);
  suture::reserveFor<decltype(JointConfigurationSlot::position_min)>(value.position_min);
  suture::reserveFor<decltype(JointConfigurationSlot::position_max)>(value.position_max);
  suture::reserveFor<decltype(JointConfigurationSlot::velocity_min)>(value.velocity_min);
  suture::reserveFor<decltype(JointConfigurationSlot::velocity_max)>(value.velocity_max);
  suture::reserveFor<decltype(JointConfigurationSlot::acceleration_min)>(value.acceleration_min);
  suture::reserveFor<decltype(JointConfigurationSlot::acceleration_max)>(value.acceleration_max);
  suture::reserveFor<decltype(JointConfigurationSlot::effort_min)>(value.effort_min);
  suture::reserveFor<decltype(JointConfigurationSlot::effort_max)>(value.effort_max);
}

bool store(const ServoJoint& value, ServoJointSlot& slot) {
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

void load(const ServoJointSlot& slot, ServoJoint& value) {
  load(slot.name, value.name);
  load(slot.mode, value.mode);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
  load(slot.position_projection, value.position_projection);
  load(slot.stamp, value.stamp);
}

void reserve(const ServoJointSlot*, ServoJoint& value) {
  suture::reserveFor<decltype(ServoJointSlot::name)>(value.name);
  suture::reserveFor<decltype(ServoJointSlot::mode)>(value.mode);
  suture::reserveFor<decltype(ServoJointSlot::position)>(value.position);
  suture::reserveFor<decltype(ServoJointSlot::velocity)>(value.velocity);
  suture::reserveFor<decltype(ServoJointSlot::effort)>(value.effort);
  suture::reserveFor<decltype(ServoJointSlot::position_projection)>(value.position_projection);
}

void shiftStamps(ServoJointSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const ActuatorJointCoupling& value, ActuatorJointCouplingSlot& slot) {
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.actuators, slot.actuators);
  fits &= store(value.actuator_to_joint_position, slot.actuator_to_joint_position);
  fits &= store(value.joint_to_actuator_position, slot.joint_to_actuator_position);
  fits &= store(value.actuator_to_joint_effort, slot.actuator_to_joint_effort);
  fits &= store(value.joint_to_actuator_effort, slot.joint_to_actuator_effort);
  return fits;
}

void load(const ActuatorJointCouplingSlot& slot, ActuatorJointCoupling& value) {
  load(slot.joints, value.joints);
  load(slot.actuators, value.actuators);
  load(slot.actuator_to_joint_position, value.actuator_to_joint_position);
  load(slot.joint_to_actuator_position, value.joint_to_actuator_position);
  load(slot.actuator_to_joint_effort, value.actuator_to_joint_effort);
  load(slot.joint_to_actuator_effort, value.joint_to_actuator_effort);
}

void reserve(const ActuatorJointCouplingSlot*, ActuatorJointCoupling& value) {
  suture::reserveFor<decltype(ActuatorJointCouplingSlot::actuator_to_joint_position)>(
      value.actuator_to_joint_position);
  suture::reserveFor<decltype(ActuatorJointCouplingSlot::joint_to_actuator_position)>(
      value.joint_to_actuator_position);
  suture::reserveFor<decltype(ActuatorJointCouplingSlot::actuator_to_joint_effort)>(
      value.actuator_to_joint_effort);
  suture::reserveFor<decltype(ActuatorJointCouplingSlot::joint_to_actuator_effort)>(
      value.joint_to_actuator_effort);
}

bool store(const Jacobian& value, JacobianSlot& slot) {
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.coefficients, slot.coefficients);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const JacobianSlot& slot, Jacobian& value) {
  load(slot.joints, value.joints);
  load(slot.coefficients, value.coefficients);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void reserve(const JacobianSlot*, Jacobian& value) {
  suture::reserveFor<decltype(JacobianSlot::coefficients)>(value.coefficients);
}

void shiftStamps(JacobianSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool isKnownJointType(std::uint8_t slot) {
  switch (static_cast<JointType>(slot)) {
    case JointType::Undefined:
    case JointType::Prismatic:
    case JointType::Revolute:
    case JointType::Universal:
    case JointType::BallSocket:
    case JointType::Inactive:
      return true;
  }
  return false;
}

bool isValid(const JointPositionSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

bool isValid(const JointPositionGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.goal, path)) return suture::refusedAt(path, "goal");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  return isValid(slot.acceleration, path) || suture::refusedAt(path, "acceleration");
}

bool isValid(const JointVelocitySlot& slot, suture::FieldPath* path) {
  return isValid(slot.velocity, path) || suture::refusedAt(path, "velocity");
}

bool isValid(const JointVelocityGoalSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.goal, path)) return suture::refusedAt(path, "goal");
  if (!isValid(slot.acceleration, path)) return suture::refusedAt(path, "acceleration");
  if (!isValid(slot.deceleration, path)) return suture::refusedAt(path, "deceleration");
  return isValid(slot.guard, path) || suture::refusedAt(path, "guard");
}

bool isValid(const JointEffortGoalSlot& slot, suture::FieldPath* path) {
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

bool isValid(const JointConfigurationSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.type, path, [](const std::uint8_t& element) {
    return isKnownJointType(element);
  })) {
    return suture::refusedAt(path, "type");
  }
  if (!isValid(slot.position_min, path)) return suture::refusedAt(path, "position_min");
  if (!isValid(slot.position_max, path)) return suture::refusedAt(path, "position_max");
  if (!isValid(slot.velocity_min, path)) return suture::refusedAt(path, "velocity_min");
  if (!isValid(slot.velocity_max, path)) return suture::refusedAt(path, "velocity_max");
  if (!isValid(slot.acceleration_min, path)) return suture::refusedAt(path, "acceleration_min");
  if (!isValid(slot.acceleration_max, path)) return suture::refusedAt(path, "acceleration_max");
  if (!isValid(slot.effort_min, path)) return suture::refusedAt(path, "effort_min");
  return isValid(slot.effort_max, path) || suture::refusedAt(path, "effort_max");
}

bool isValid(const ServoJointSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  if (!isValid(slot.effort, path)) return suture::refusedAt(path, "effort");
  return isValid(slot.position_projection, path) || suture::refusedAt(path, "position_projection");
}

bool isValid(const ActuatorJointCouplingSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.actuator_to_joint_position, path)) {
    return suture::refusedAt(path, "actuator_to_joint_position");
  }
  if (!isValid(slot.joint_to_actuator_position, path)) {
    return suture::refusedAt(path, "joint_to_actuator_position");
  }
  if (!isValid(slot.actuator_to_joint_effort, path)) {
    return suture::refusedAt(path, "actuator_to_joint_effort");
  }
  return isValid(slot.joint_to_actuator_effort, path) ||
      suture::refusedAt(path, "joint_to_actuator_effort");
}

bool isValid(const JacobianSlot& slot, suture::FieldPath* path) {
  return isValid(slot.coefficients, path) || suture::refusedAt(path, "coefficients");
}

}  // namespace robots
