// Written by suturec from robot_types/joint_commands.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/joint_commands.capnp.h"
#include "robot_types/joint_commands.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::JointType wireJointType(std::uint8_t slot) {
  switch (static_cast<JointType>(slot)) {
    case JointType::Undefined: return wire::JointType::UNDEFINED;
    case JointType::Prismatic: return wire::JointType::PRISMATIC;
    case JointType::Revolute: return wire::JointType::REVOLUTE;
    case JointType::Universal: return wire::JointType::UNIVERSAL;
    case JointType::BallSocket: return wire::JointType::BALL_SOCKET;
    case JointType::Inactive: return wire::JointType::INACTIVE;
  }
  return wire::JointType{};
}

suture::Errc fromWire(wire::JointType in, std::uint8_t& slot) {
  switch (in) {
    case wire::JointType::UNDEFINED: return slot =
        static_cast<std::uint8_t>(JointType::Undefined), suture::Errc{};
    case wire::JointType::PRISMATIC: return slot =
        static_cast<std::uint8_t>(JointType::Prismatic), suture::Errc{};
    case wire::JointType::REVOLUTE: return slot =
        static_cast<std::uint8_t>(JointType::Revolute), suture::Errc{};
    case wire::JointType::UNIVERSAL: return slot =
        static_cast<std::uint8_t>(JointType::Universal), suture::Errc{};
    case wire::JointType::BALL_SOCKET: return slot =
        static_cast<std::uint8_t>(JointType::BallSocket), suture::Errc{};
    case wire::JointType::INACTIVE: return slot =
        static_cast<std::uint8_t>(JointType::Inactive), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const JointPositionSlot& slot, wire::JointPosition::Builder out) {
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  toWire(slot.stamps, out.initStamps(sizeOf(slot.stamps)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::JointPosition::Reader in, JointPositionSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getPosition(), slot.position),
      suture::codec::fromWireList(in.getStamps(), slot.stamps,
                                  [&](auto item, std::int64_t& target) {
                                    return target = suture::codec::shifted(item, shift), suture::Errc{};
                                  }),
  });
}

void toWire(const JointPositionGoalSlot& slot, wire::JointPositionGoal::Builder out) {
  toWire(slot.goal, out.initGoal(sizeOf(slot.goal)));
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  toWire(slot.acceleration, out.initAcceleration(sizeOf(slot.acceleration)));
  out.setTimeLimit(slot.time_limit);
  out.setIsCoordinated(slot.is_coordinated != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::JointPositionGoal::Reader in, JointPositionGoalSlot& slot,
                      suture::Duration shift) {
  slot.time_limit = in.getTimeLimit();
  slot.is_coordinated = in.getIsCoordinated();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getGoal(), slot.goal),
      fromWire(in.getVelocity(), slot.velocity),
      fromWire(in.getAcceleration(), slot.acceleration),
  });
}

void toWire(const JointVelocitySlot& slot, wire::JointVelocity::Builder out) {
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::JointVelocity::Reader in, JointVelocitySlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return fromWire(in.getVelocity(), slot.velocity);
}

void toWire(const JointVelocityGoalSlot& slot, wire::JointVelocityGoal::Builder out) {
  toWire(slot.goal, out.initGoal(sizeOf(slot.goal)));
  toWire(slot.acceleration, out.initAcceleration(sizeOf(slot.acceleration)));
  toWire(slot.deceleration, out.initDeceleration(sizeOf(slot.deceleration)));
  toWire(slot.guard, out.initGuard(sizeOf(slot.guard)));
  toWire(slot.mask, out.initMask(sizeOf(slot.mask)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::JointVelocityGoal::Reader in, JointVelocityGoalSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getGoal(), slot.goal),
      fromWire(in.getAcceleration(), slot.acceleration),
      fromWire(in.getDeceleration(), slot.deceleration),
      fromWire(in.getGuard(), slot.guard),
      fromWire(in.getMask(), slot.mask),
  });
}

void toWire(const JointEffortGoalSlot& slot, wire::JointEffortGoal::Builder out) {
  toWire(slot.effort, out.initEffort(sizeOf(slot.effort)));
  toWire(slot.mask, out.initMask(sizeOf(slot.mask)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::JointEffortGoal::Reader in, JointEffortGoalSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getEffort(), slot.effort),
      fromWire(in.getMask(), slot.mask),
  });
}

void toWire(const JointConfigurationSlot& slot, wire::JointConfiguration::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  suture::codec::toWireList(slot.type, out.initType(sizeOf(slot.type)),
                            [](const std::uint8_t& element, auto list, std::uint32_t i) {
                              list.set(i, wireJointType(element));
                            });
  toWire(slot.position_min, out.initPositionMin(sizeOf(slot.position_min)));
  toWire(slot.position_max, out.initPositionMax(sizeOf(slot.position_max)));
  toWire(slot.velocity_min, out.initVelocityMin(sizeOf(slot.velocity_min)));
  toWire(slot.velocity_max, out.initVelocityMax(sizeOf(slot.velocity_max)));
  toWire(slot.acceleration_min, out.initAccelerationMin(sizeOf(slot.acceleration_min)));
  toWire(slot.acceleration_max, out.initAccelerationMax(sizeOf(slot.acceleration_max)));
  toWire(slot.effort_min, out.initEffortMin(sizeOf(slot.effort_min)));
  toWire(slot.effort_max, out.initEffortMax(sizeOf(slot.effort_max)));
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::JointConfiguration::Reader in, JointConfigurationSlot& slot,
                      suture::Duration) {
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      suture::codec::fromWireList(in.getType(), slot.type, [](auto item, std::uint8_t& target) {
        return fromWire(item, target);
      }),
      fromWire(in.getPositionMin(), slot.position_min),
      fromWire(in.getPositionMax(), slot.position_max),
      fromWire(in.getVelocityMin(), slot.velocity_min),
      fromWire(in.getVelocityMax(), slot.velocity_max),
      fromWire(in.getAccelerationMin(), slot.acceleration_min),
      fromWire(in.getAccelerationMax(), slot.acceleration_max),
      fromWire(in.getEffortMin(), slot.effort_min),
      fromWire(in.getEffortMax(), slot.effort_max),
  });
}

void toWire(const ServoJointSlot& slot, wire::ServoJoint::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.mode, out.initMode(sizeOf(slot.mode)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  toWire(slot.effort, out.initEffort(sizeOf(slot.effort)));
  toWire(slot.position_projection, out.initPositionProjection(sizeOf(slot.position_projection)));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::ServoJoint::Reader in, ServoJointSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getMode(), slot.mode),
      fromWire(in.getPosition(), slot.position),
      fromWire(in.getVelocity(), slot.velocity),
      fromWire(in.getEffort(), slot.effort),
      fromWire(in.getPositionProjection(), slot.position_projection),
  });
}

void toWire(const ActuatorJointCouplingSlot& slot, wire::ActuatorJointCoupling::Builder out) {
  out.setJoints(slot.joints);
  out.setActuators(slot.actuators);
  toWire(slot.actuator_to_joint_position,
         out.initActuatorToJointPosition(sizeOf(slot.actuator_to_joint_position)));
  toWire(slot.joint_to_actuator_position,
         out.initJointToActuatorPosition(sizeOf(slot.joint_to_actuator_position)));
  toWire(slot.actuator_to_joint_effort,
         out.initActuatorToJointEffort(sizeOf(slot.actuator_to_joint_effort)));
  toWire(slot.joint_to_actuator_effort,
         out.initJointToActuatorEffort(sizeOf(slot.joint_to_actuator_effort)));
}

suture::Errc fromWire(wire::ActuatorJointCoupling::Reader in, ActuatorJointCouplingSlot& slot,
                      suture::Duration) {
  slot.joints = in.getJoints();
  slot.actuators = in.getActuators();
  return suture::codec::firstError({
      fromWire(in.getActuatorToJointPosition(), slot.actuator_to_joint_position),
      fromWire(in.getJointToActuatorPosition(), slot.joint_to_actuator_position),
      fromWire(in.getActuatorToJointEffort(), slot.actuator_to_joint_effort),
      fromWire(in.getJointToActuatorEffort(), slot.joint_to_actuator_effort),
  });
}

void toWire(const JacobianSlot& slot, wire::Jacobian::Builder out) {
  out.setJoints(slot.joints);
  toWire(slot.coefficients, out.initCoefficients(sizeOf(slot.coefficients)));
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::Jacobian::Reader in, JacobianSlot& slot, suture::Duration shift) {
  slot.joints = in.getJoints();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return fromWire(in.getCoefficients(), slot.coefficients);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::JointPosition& value) {
  return codec::encodeAs<robots::wire::JointPosition, robots::JointPositionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointPosition& value) {
  return codec::decodeAs<robots::wire::JointPosition, robots::JointPositionSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointPositionGoal& value) {
  return codec::encodeAs<robots::wire::JointPositionGoal, robots::JointPositionGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointPositionGoal& value) {
  return codec::decodeAs<robots::wire::JointPositionGoal,
                         robots::JointPositionGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointVelocity& value) {
  return codec::encodeAs<robots::wire::JointVelocity, robots::JointVelocitySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointVelocity& value) {
  return codec::decodeAs<robots::wire::JointVelocity, robots::JointVelocitySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointVelocityGoal& value) {
  return codec::encodeAs<robots::wire::JointVelocityGoal, robots::JointVelocityGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointVelocityGoal& value) {
  return codec::decodeAs<robots::wire::JointVelocityGoal,
                         robots::JointVelocityGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointEffortGoal& value) {
  return codec::encodeAs<robots::wire::JointEffortGoal, robots::JointEffortGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointEffortGoal& value) {
  return codec::decodeAs<robots::wire::JointEffortGoal, robots::JointEffortGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::JointConfiguration& value) {
  return codec::encodeAs<robots::wire::JointConfiguration, robots::JointConfigurationSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::JointConfiguration& value) {
  return codec::decodeAs<robots::wire::JointConfiguration,
                         robots::JointConfigurationSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ServoJoint& value) {
  return codec::encodeAs<robots::wire::ServoJoint, robots::ServoJointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ServoJoint& value) {
  return codec::decodeAs<robots::wire::ServoJoint, robots::ServoJointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ActuatorJointCoupling& value) {
  return codec::encodeAs<robots::wire::ActuatorJointCoupling,
                         robots::ActuatorJointCouplingSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ActuatorJointCoupling& value) {
  return codec::decodeAs<robots::wire::ActuatorJointCoupling,
                         robots::ActuatorJointCouplingSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::Jacobian& value) {
  return codec::encodeAs<robots::wire::Jacobian, robots::JacobianSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Jacobian& value) {
  return codec::decodeAs<robots::wire::Jacobian, robots::JacobianSlot>(bytes, value);
}

}  // namespace suture
