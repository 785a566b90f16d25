// Written by suturec from surgeon/knot_surgeon.h. Do not edit.
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include "surgeon/knot_surgeon.capnp.h"
#include "surgeon/knot_surgeon.suture.h"

namespace robots {

using suture::rpc::fromWire;
using suture::rpc::toWire;

// --- between slots and Cap'n Proto

void toWire(const KnotSurgeonParametersSlot& slot, wire::KnotSurgeonParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.carry, out.initCarry());
  out.setDuration(slot.duration);
  out.setSway(slot.sway);
  out.setSwayFrequency(slot.sway_frequency);
}

suture::Errc fromWire(wire::KnotSurgeonParameters::Reader in, KnotSurgeonParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.duration = in.getDuration();
  slot.sway = in.getSway();
  slot.sway_frequency = in.getSwayFrequency();
  return in.hasCarry() ? fromWire(in.getCarry(), slot.carry)
      : suture::rpc::fromDefault(KnotSurgeonParameters().carry, slot.carry);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotSurgeonParameters& value) {
  return rpc::encodeAs<robots::wire::KnotSurgeonParameters,
                       robots::KnotSurgeonParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotSurgeonParameters& value) {
  return rpc::decodeAs<robots::wire::KnotSurgeonParameters,
                       robots::KnotSurgeonParametersSlot>(bytes, value);
}

}  // namespace suture
