// Written by suturec from strand/strand_simulation.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "strand/strand_simulation.capnp.h"
#include "strand/strand_simulation.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const StrandParametersSlot& slot, wire::StrandParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setLength(slot.length);
  out.setFriction(slot.friction);
  out.setWrap(slot.wrap);
}

suture::Errc fromWire(wire::StrandParameters::Reader in, StrandParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.length = in.getLength();
  slot.friction = in.getFriction();
  slot.wrap = in.getWrap();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandParameters& value) {
  return codec::encodeAs<robots::wire::StrandParameters, robots::StrandParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandParameters& value) {
  return codec::decodeAs<robots::wire::StrandParameters,
                         robots::StrandParametersSlot>(bytes, value);
}

}  // namespace suture
