// Written by suturec from arm_control/mtm.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "arm_control/mtm.capnp.h"
#include "arm_control/mtm.suture.h"

// Defined in robot_types/side.wire.cpp.
namespace robots {
wire::Side wireSide(std::uint8_t slot);
suture::Errc fromWire(wire::Side in, std::uint8_t& slot);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const MtmParametersSlot& slot, wire::MtmParameters::Builder out) {
  out.setSide(wireSide(slot.side));
  out.setPeriod(slot.period);
  out.setAngularRate(slot.angular_rate);
  out.setAngularAcceleration(slot.angular_acceleration);
  out.setFollowingError(slot.following_error);
  out.setJumpFactor(slot.jump_factor);
  out.setOverloadTime(slot.overload_time);
  out.setServoHorizon(slot.servo_horizon);
  out.setGripperClosed(slot.gripper_closed);
  out.setGripperDebounce(slot.gripper_debounce);
}

suture::Errc fromWire(wire::MtmParameters::Reader in, MtmParametersSlot& slot, suture::Duration) {
  slot.period = in.getPeriod();
  slot.angular_rate = in.getAngularRate();
  slot.angular_acceleration = in.getAngularAcceleration();
  slot.following_error = in.getFollowingError();
  slot.jump_factor = in.getJumpFactor();
  slot.overload_time = in.getOverloadTime();
  slot.servo_horizon = in.getServoHorizon();
  slot.gripper_closed = in.getGripperClosed();
  slot.gripper_debounce = in.getGripperDebounce();
  return fromWire(in.getSide(), slot.side);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::MtmParameters& value) {
  return codec::encodeAs<robots::wire::MtmParameters, robots::MtmParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::MtmParameters& value) {
  return codec::decodeAs<robots::wire::MtmParameters, robots::MtmParametersSlot>(bytes, value);
}

}  // namespace suture
