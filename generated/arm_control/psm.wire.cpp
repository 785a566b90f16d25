// Written by suturec from arm_control/psm.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "arm_control/psm.capnp.h"
#include "arm_control/psm.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PsmParametersSlot& slot, wire::PsmParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setAngularRate(slot.angular_rate);
  out.setHomeInsertion(slot.home_insertion);
  out.setFollowingError(slot.following_error);
  out.setInsertionRate(slot.insertion_rate);
  out.setInsertionFollowingError(slot.insertion_following_error);
  out.setAngularAcceleration(slot.angular_acceleration);
  out.setInsertionAcceleration(slot.insertion_acceleration);
  out.setJawAcceleration(slot.jaw_acceleration);
  out.setJawRate(slot.jaw_rate);
  out.setJumpFactor(slot.jump_factor);
  out.setOverloadTime(slot.overload_time);
  out.setServoHorizon(slot.servo_horizon);
}

suture::Errc fromWire(wire::PsmParameters::Reader in, PsmParametersSlot& slot, suture::Duration) {
  slot.period = in.getPeriod();
  slot.angular_rate = in.getAngularRate();
  slot.home_insertion = in.getHomeInsertion();
  slot.following_error = in.getFollowingError();
  slot.insertion_rate = in.getInsertionRate();
  slot.insertion_following_error = in.getInsertionFollowingError();
  slot.angular_acceleration = in.getAngularAcceleration();
  slot.insertion_acceleration = in.getInsertionAcceleration();
  slot.jaw_acceleration = in.getJawAcceleration();
  slot.jaw_rate = in.getJawRate();
  slot.jump_factor = in.getJumpFactor();
  slot.overload_time = in.getOverloadTime();
  slot.servo_horizon = in.getServoHorizon();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PsmParameters& value) {
  return codec::encodeAs<robots::wire::PsmParameters, robots::PsmParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PsmParameters& value) {
  return codec::decodeAs<robots::wire::PsmParameters, robots::PsmParametersSlot>(bytes, value);
}

}  // namespace suture
