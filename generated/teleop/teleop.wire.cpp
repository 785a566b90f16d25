// Written by suturec from teleop/teleop.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "teleop/teleop.capnp.h"
#include "teleop/teleop.suture.h"

// Defined in robot_types/side.wire.cpp.
namespace robots {
wire::Side wireSide(std::uint8_t slot);
suture::Errc fromWire(wire::Side in, std::uint8_t& slot);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const TeleopParametersSlot& slot, wire::TeleopParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setScale(slot.scale);
  out.setMaxAge(slot.max_age);
  out.setEnableAtStart(slot.enable_at_start != 0);
  out.setAlign(slot.align != 0);
  out.setAlignmentTolerance(slot.alignment_tolerance);
  out.setReleaseMaster(slot.release_master != 0);
  out.setPreparationLimit(slot.preparation_limit);
  out.setOperatorAge(slot.operator_age);
  out.setRegistrationAge(slot.registration_age);
  out.setJawScale(slot.jaw_scale);
  out.setJawOffset(slot.jaw_offset);
  out.setJawRate(slot.jaw_rate);
  out.setJawGhostRate(slot.jaw_ghost_rate);
  out.setJawTolerance(slot.jaw_tolerance);
  out.setMasterSide(wireSide(slot.master_side));
  out.setSlaveSide(wireSide(slot.slave_side));
}

suture::Errc fromWire(wire::TeleopParameters::Reader in, TeleopParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.scale = in.getScale();
  slot.max_age = in.getMaxAge();
  slot.enable_at_start = in.getEnableAtStart();
  slot.align = in.getAlign();
  slot.alignment_tolerance = in.getAlignmentTolerance();
  slot.release_master = in.getReleaseMaster();
  slot.preparation_limit = in.getPreparationLimit();
  slot.operator_age = in.getOperatorAge();
  slot.registration_age = in.getRegistrationAge();
  slot.jaw_scale = in.getJawScale();
  slot.jaw_offset = in.getJawOffset();
  slot.jaw_rate = in.getJawRate();
  slot.jaw_ghost_rate = in.getJawGhostRate();
  slot.jaw_tolerance = in.getJawTolerance();
  return suture::codec::firstError({
      fromWire(in.getMasterSide(), slot.master_side),
      fromWire(in.getSlaveSide(), slot.slave_side),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::TeleopParameters& value) {
  return codec::encodeAs<robots::wire::TeleopParameters, robots::TeleopParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TeleopParameters& value) {
  return codec::decodeAs<robots::wire::TeleopParameters,
                         robots::TeleopParametersSlot>(bytes, value);
}

}  // namespace suture
