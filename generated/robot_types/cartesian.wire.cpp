// Written by suturec from robot_types/cartesian.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/cartesian.capnp.h"
#include "robot_types/cartesian.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ServoMode wireServoMode(std::uint8_t slot) {
  switch (static_cast<ServoMode>(slot)) {
    case ServoMode::None: return wire::ServoMode::NONE;
    case ServoMode::Position: return wire::ServoMode::POSITION;
    case ServoMode::Velocity: return wire::ServoMode::VELOCITY;
    case ServoMode::PositionVelocity: return wire::ServoMode::POSITION_VELOCITY;
    case ServoMode::Effort: return wire::ServoMode::EFFORT;
    case ServoMode::PositionEffort: return wire::ServoMode::POSITION_EFFORT;
    case ServoMode::VelocityEffort: return wire::ServoMode::VELOCITY_EFFORT;
    case ServoMode::All: return wire::ServoMode::ALL;
  }
  return wire::ServoMode{};
}

suture::Errc fromWire(wire::ServoMode in, std::uint8_t& slot) {
  switch (in) {
    case wire::ServoMode::NONE: return slot =
        static_cast<std::uint8_t>(ServoMode::None), suture::Errc{};
    case wire::ServoMode::POSITION: return slot =
        static_cast<std::uint8_t>(ServoMode::Position), suture::Errc{};
    case wire::ServoMode::VELOCITY: return slot =
        static_cast<std::uint8_t>(ServoMode::Velocity), suture::Errc{};
    case wire::ServoMode::POSITION_VELOCITY: return slot =
        static_cast<std::uint8_t>(ServoMode::PositionVelocity), suture::Errc{};
    case wire::ServoMode::EFFORT: return slot =
        static_cast<std::uint8_t>(ServoMode::Effort), suture::Errc{};
    case wire::ServoMode::POSITION_EFFORT: return slot =
        static_cast<std::uint8_t>(ServoMode::PositionEffort), suture::Errc{};
    case wire::ServoMode::VELOCITY_EFFORT: return slot =
        static_cast<std::uint8_t>(ServoMode::VelocityEffort), suture::Errc{};
    case wire::ServoMode::ALL: return slot =
        static_cast<std::uint8_t>(ServoMode::All), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const TwistSlot& slot, wire::Twist::Builder out) {
  toWire(slot.linear, out.initLinear());
  toWire(slot.angular, out.initAngular());
  out.setMovingFrame(slot.moving_frame);
  out.setReferenceFrame(slot.reference_frame);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::Twist::Reader in, TwistSlot& slot, suture::Duration shift) {
  slot.moving_frame = in.getMovingFrame();
  slot.reference_frame = in.getReferenceFrame();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasLinear() ? fromWire(in.getLinear(), slot.linear)
          : suture::codec::fromDefault(Twist().linear, slot.linear),
      in.hasAngular() ? fromWire(in.getAngular(), slot.angular)
          : suture::codec::fromDefault(Twist().angular, slot.angular),
  });
}

void toWire(const TwistGoalSlot& slot, wire::TwistGoal::Builder out) {
  toWire(slot.linear, out.initLinear());
  toWire(slot.angular, out.initAngular());
  toWire(slot.linear_acceleration, out.initLinearAcceleration());
  toWire(slot.angular_acceleration, out.initAngularAcceleration());
  toWire(slot.mask, out.initMask(6));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::TwistGoal::Reader in, TwistGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      in.hasLinear() ? fromWire(in.getLinear(), slot.linear)
          : suture::codec::fromDefault(TwistGoal().linear, slot.linear),
      in.hasAngular() ? fromWire(in.getAngular(), slot.angular)
          : suture::codec::fromDefault(TwistGoal().angular, slot.angular),
      in.hasLinearAcceleration() ? fromWire(in.getLinearAcceleration(), slot.linear_acceleration)
          : suture::codec::fromDefault(TwistGoal().linear_acceleration, slot.linear_acceleration),
      in.hasAngularAcceleration() ? fromWire(in.getAngularAcceleration(), slot.angular_acceleration)
          : suture::codec::fromDefault(TwistGoal().angular_acceleration, slot.angular_acceleration),
      in.getMask().size() != 0 ? fromWire(in.getMask(), slot.mask)
          : suture::codec::fromDefault(TwistGoal().mask, slot.mask),
  });
}

void toWire(const WrenchSlot& slot, wire::Wrench::Builder out) {
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
  toWire(slot.mask, out.initMask(6));
  out.setMovingFrame(slot.moving_frame);
  out.setReferenceFrame(slot.reference_frame);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::Wrench::Reader in, WrenchSlot& slot, suture::Duration shift) {
  slot.moving_frame = in.getMovingFrame();
  slot.reference_frame = in.getReferenceFrame();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasForce() ? fromWire(in.getForce(), slot.force)
          : suture::codec::fromDefault(Wrench().force, slot.force),
      in.hasTorque() ? fromWire(in.getTorque(), slot.torque)
          : suture::codec::fromDefault(Wrench().torque, slot.torque),
      in.getMask().size() != 0 ? fromWire(in.getMask(), slot.mask)
          : suture::codec::fromDefault(Wrench().mask, slot.mask),
  });
}

void toWire(const WrenchGoalSlot& slot, wire::WrenchGoal::Builder out) {
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
  toWire(slot.mask, out.initMask(6));
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::WrenchGoal::Reader in, WrenchGoalSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      in.hasForce() ? fromWire(in.getForce(), slot.force)
          : suture::codec::fromDefault(WrenchGoal().force, slot.force),
      in.hasTorque() ? fromWire(in.getTorque(), slot.torque)
          : suture::codec::fromDefault(WrenchGoal().torque, slot.torque),
      in.getMask().size() != 0 ? fromWire(in.getMask(), slot.mask)
          : suture::codec::fromDefault(WrenchGoal().mask, slot.mask),
  });
}

void toWire(const CartesianStateSlot& slot, wire::CartesianState::Builder out) {
  out.setMovingFrame(slot.moving_frame);
  out.setReferenceFrame(slot.reference_frame);
  toWire(slot.position, out.initPosition());
  out.setPositionIsValid(slot.position_is_valid != 0);
  toWire(slot.linear_velocity, out.initLinearVelocity());
  toWire(slot.angular_velocity, out.initAngularVelocity());
  out.setVelocityIsValid(slot.velocity_is_valid != 0);
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
  out.setForceIsValid(slot.force_is_valid != 0);
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::CartesianState::Reader in, CartesianStateSlot& slot,
                      suture::Duration shift) {
  slot.moving_frame = in.getMovingFrame();
  slot.reference_frame = in.getReferenceFrame();
  slot.position_is_valid = in.getPositionIsValid();
  slot.velocity_is_valid = in.getVelocityIsValid();
  slot.force_is_valid = in.getForceIsValid();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::codec::fromDefault(CartesianState().position, slot.position),
      in.hasLinearVelocity() ? fromWire(in.getLinearVelocity(), slot.linear_velocity)
          : suture::codec::fromDefault(CartesianState().linear_velocity, slot.linear_velocity),
      in.hasAngularVelocity() ? fromWire(in.getAngularVelocity(), slot.angular_velocity)
          : suture::codec::fromDefault(CartesianState().angular_velocity, slot.angular_velocity),
      in.hasForce() ? fromWire(in.getForce(), slot.force)
          : suture::codec::fromDefault(CartesianState().force, slot.force),
      in.hasTorque() ? fromWire(in.getTorque(), slot.torque)
          : suture::codec::fromDefault(CartesianState().torque, slot.torque),
  });
}

void toWire(const CartesianGoalSlot& slot, wire::CartesianGoal::Builder out) {
  toWire(slot.goal, out.initGoal());
  toWire(slot.linear_velocity, out.initLinearVelocity());
  toWire(slot.angular_velocity, out.initAngularVelocity());
  toWire(slot.linear_acceleration, out.initLinearAcceleration());
  toWire(slot.angular_acceleration, out.initAngularAcceleration());
  toWire(slot.mask, out.initMask(2));
  out.setMovingFrame(slot.moving_frame);
  out.setReferenceFrame(slot.reference_frame);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::CartesianGoal::Reader in, CartesianGoalSlot& slot,
                      suture::Duration shift) {
  slot.moving_frame = in.getMovingFrame();
  slot.reference_frame = in.getReferenceFrame();
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::codec::firstError({
      in.hasGoal() ? fromWire(in.getGoal(), slot.goal)
          : suture::codec::fromDefault(CartesianGoal().goal, slot.goal),
      in.hasLinearVelocity() ? fromWire(in.getLinearVelocity(), slot.linear_velocity)
          : suture::codec::fromDefault(CartesianGoal().linear_velocity, slot.linear_velocity),
      in.hasAngularVelocity() ? fromWire(in.getAngularVelocity(), slot.angular_velocity)
          : suture::codec::fromDefault(CartesianGoal().angular_velocity, slot.angular_velocity),
      in.hasLinearAcceleration() ? fromWire(in.getLinearAcceleration(), slot.linear_acceleration)
          : suture::codec::fromDefault(CartesianGoal().linear_acceleration, slot.linear_acceleration),
      in.hasAngularAcceleration() ? fromWire(in.getAngularAcceleration(), slot.angular_acceleration)
          : suture::codec::fromDefault(CartesianGoal().angular_acceleration, slot.angular_acceleration),
      in.getMask().size() != 0 ? fromWire(in.getMask(), slot.mask)
          : suture::codec::fromDefault(CartesianGoal().mask, slot.mask),
  });
}

void toWire(const ServoCartesianSlot& slot, wire::ServoCartesian::Builder out) {
  toWire(slot.task_frame, out.initTaskFrame());
  toWire(slot.position, out.initPosition());
  toWire(slot.linear_velocity, out.initLinearVelocity());
  toWire(slot.angular_velocity, out.initAngularVelocity());
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
  suture::codec::toWireList(slot.axis_mode, out.initAxisMode(6),
                            [](const std::uint8_t& element, auto list, std::uint32_t i) {
                              list.set(i, wireServoMode(element));
                            });
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::ServoCartesian::Reader in, ServoCartesianSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      in.hasTaskFrame() ? fromWire(in.getTaskFrame(), slot.task_frame)
          : suture::codec::fromDefault(ServoCartesian().task_frame, slot.task_frame),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::codec::fromDefault(ServoCartesian().position, slot.position),
      in.hasLinearVelocity() ? fromWire(in.getLinearVelocity(), slot.linear_velocity)
          : suture::codec::fromDefault(ServoCartesian().linear_velocity, slot.linear_velocity),
      in.hasAngularVelocity() ? fromWire(in.getAngularVelocity(), slot.angular_velocity)
          : suture::codec::fromDefault(ServoCartesian().angular_velocity, slot.angular_velocity),
      in.hasForce() ? fromWire(in.getForce(), slot.force)
          : suture::codec::fromDefault(ServoCartesian().force, slot.force),
      in.hasTorque() ? fromWire(in.getTorque(), slot.torque)
          : suture::codec::fromDefault(ServoCartesian().torque, slot.torque),
      suture::codec::fromWireList(in.getAxisMode(), slot.axis_mode,
                                  [](auto item, std::uint8_t& target) {
                                    return fromWire(item, target);
                                  }),
  });
}

void toWire(const HalfPlaneGainsSlot& slot, wire::HalfPlaneGains::Builder out) {
  toWire(slot.p, out.initP());
  toWire(slot.d, out.initD());
  toWire(slot.bias, out.initBias());
  toWire(slot.deadband, out.initDeadband());
}

suture::Errc fromWire(wire::HalfPlaneGains::Reader in, HalfPlaneGainsSlot& slot, suture::Duration) {
  return suture::codec::firstError({
      in.hasP() ? fromWire(in.getP(), slot.p)
          : suture::codec::fromDefault(HalfPlaneGains().p, slot.p),
      in.hasD() ? fromWire(in.getD(), slot.d)
          : suture::codec::fromDefault(HalfPlaneGains().d, slot.d),
      in.hasBias() ? fromWire(in.getBias(), slot.bias)
          : suture::codec::fromDefault(HalfPlaneGains().bias, slot.bias),
      in.hasDeadband() ? fromWire(in.getDeadband(), slot.deadband)
          : suture::codec::fromDefault(HalfPlaneGains().deadband, slot.deadband),
  });
}

void toWire(const AngularHalfPlaneGainsSlot& slot, wire::AngularHalfPlaneGains::Builder out) {
  toWire(slot.p, out.initP());
  toWire(slot.d, out.initD());
  toWire(slot.bias, out.initBias());
  toWire(slot.deadband, out.initDeadband());
}

suture::Errc fromWire(wire::AngularHalfPlaneGains::Reader in, AngularHalfPlaneGainsSlot& slot,
                      suture::Duration) {
  return suture::codec::firstError({
      in.hasP() ? fromWire(in.getP(), slot.p)
          : suture::codec::fromDefault(AngularHalfPlaneGains().p, slot.p),
      in.hasD() ? fromWire(in.getD(), slot.d)
          : suture::codec::fromDefault(AngularHalfPlaneGains().d, slot.d),
      in.hasBias() ? fromWire(in.getBias(), slot.bias)
          : suture::codec::fromDefault(AngularHalfPlaneGains().bias, slot.bias),
      in.hasDeadband() ? fromWire(in.getDeadband(), slot.deadband)
          : suture::codec::fromDefault(AngularHalfPlaneGains().deadband, slot.deadband),
  });
}

void toWire(const CartesianImpedanceSlot& slot, wire::CartesianImpedance::Builder out) {
  toWire(slot.force_orientation, out.initForceOrientation());
  toWire(slot.force_position, out.initForcePosition());
  toWire(slot.torque_orientation, out.initTorqueOrientation());
  toWire(slot.position_positive, out.initPositionPositive());
  toWire(slot.position_negative, out.initPositionNegative());
  toWire(slot.orientation_positive, out.initOrientationPositive());
  toWire(slot.orientation_negative, out.initOrientationNegative());
  out.setStamp(slot.stamp);
}

suture::Errc fromWire(wire::CartesianImpedance::Reader in, CartesianImpedanceSlot& slot,
                      suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  return suture::codec::firstError({
      in.hasForceOrientation() ? fromWire(in.getForceOrientation(), slot.force_orientation)
          : suture::codec::fromDefault(CartesianImpedance().force_orientation, slot.force_orientation),
      in.hasForcePosition() ? fromWire(in.getForcePosition(), slot.force_position)
          : suture::codec::fromDefault(CartesianImpedance().force_position, slot.force_position),
      in.hasTorqueOrientation() ? fromWire(in.getTorqueOrientation(), slot.torque_orientation)
          : suture::codec::fromDefault(CartesianImpedance().torque_orientation, slot.torque_orientation),
      fromWire(in.getPositionPositive(), slot.position_positive, shift),
      fromWire(in.getPositionNegative(), slot.position_negative, shift),
      fromWire(in.getOrientationPositive(), slot.orientation_positive, shift),
      fromWire(in.getOrientationNegative(), slot.orientation_negative, shift),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Twist& value) {
  return codec::encodeAs<robots::wire::Twist, robots::TwistSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Twist& value) {
  return codec::decodeAs<robots::wire::Twist, robots::TwistSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::TwistGoal& value) {
  return codec::encodeAs<robots::wire::TwistGoal, robots::TwistGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TwistGoal& value) {
  return codec::decodeAs<robots::wire::TwistGoal, robots::TwistGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::Wrench& value) {
  return codec::encodeAs<robots::wire::Wrench, robots::WrenchSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::Wrench& value) {
  return codec::decodeAs<robots::wire::Wrench, robots::WrenchSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::WrenchGoal& value) {
  return codec::encodeAs<robots::wire::WrenchGoal, robots::WrenchGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::WrenchGoal& value) {
  return codec::decodeAs<robots::wire::WrenchGoal, robots::WrenchGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianState& value) {
  return codec::encodeAs<robots::wire::CartesianState, robots::CartesianStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianState& value) {
  return codec::decodeAs<robots::wire::CartesianState, robots::CartesianStateSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianGoal& value) {
  return codec::encodeAs<robots::wire::CartesianGoal, robots::CartesianGoalSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianGoal& value) {
  return codec::decodeAs<robots::wire::CartesianGoal, robots::CartesianGoalSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::ServoCartesian& value) {
  return codec::encodeAs<robots::wire::ServoCartesian, robots::ServoCartesianSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ServoCartesian& value) {
  return codec::decodeAs<robots::wire::ServoCartesian, robots::ServoCartesianSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::HalfPlaneGains& value) {
  return codec::encodeAs<robots::wire::HalfPlaneGains, robots::HalfPlaneGainsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::HalfPlaneGains& value) {
  return codec::decodeAs<robots::wire::HalfPlaneGains, robots::HalfPlaneGainsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::AngularHalfPlaneGains& value) {
  return codec::encodeAs<robots::wire::AngularHalfPlaneGains,
                         robots::AngularHalfPlaneGainsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::AngularHalfPlaneGains& value) {
  return codec::decodeAs<robots::wire::AngularHalfPlaneGains,
                         robots::AngularHalfPlaneGainsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::CartesianImpedance& value) {
  return codec::encodeAs<robots::wire::CartesianImpedance, robots::CartesianImpedanceSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CartesianImpedance& value) {
  return codec::decodeAs<robots::wire::CartesianImpedance,
                         robots::CartesianImpedanceSlot>(bytes, value);
}

}  // namespace suture
