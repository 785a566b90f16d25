// Written by suturec from surgeon/knot_surgeon.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "surgeon/knot_surgeon.capnp.h"
#include "surgeon/knot_surgeon.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

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
      : suture::codec::fromDefault(KnotSurgeonParameters().carry, slot.carry);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotSurgeonParameters& value) {
  return codec::encodeAs<robots::wire::KnotSurgeonParameters,
                         robots::KnotSurgeonParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotSurgeonParameters& value) {
  return codec::decodeAs<robots::wire::KnotSurgeonParameters,
                         robots::KnotSurgeonParametersSlot>(bytes, value);
}

}  // namespace suture
