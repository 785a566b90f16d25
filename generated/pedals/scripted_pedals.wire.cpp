// Written by suturec from pedals/scripted_pedals.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "pedals/scripted_pedals.capnp.h"
#include "pedals/scripted_pedals.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const ScriptedPedalsParametersSlot& slot, wire::ScriptedPedalsParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setClutchAfter(slot.clutch_after);
  out.setClutchFor(slot.clutch_for);
  out.setLeaveAfter(slot.leave_after);
  out.setLeaveFor(slot.leave_for);
}

suture::Errc fromWire(wire::ScriptedPedalsParameters::Reader in, ScriptedPedalsParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.clutch_after = in.getClutchAfter();
  slot.clutch_for = in.getClutchFor();
  slot.leave_after = in.getLeaveAfter();
  slot.leave_for = in.getLeaveFor();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ScriptedPedalsParameters& value) {
  return codec::encodeAs<robots::wire::ScriptedPedalsParameters,
                         robots::ScriptedPedalsParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ScriptedPedalsParameters& value) {
  return codec::decodeAs<robots::wire::ScriptedPedalsParameters,
                         robots::ScriptedPedalsParametersSlot>(bytes, value);
}

}  // namespace suture
