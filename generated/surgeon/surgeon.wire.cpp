// Written by suturec from surgeon/surgeon.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "surgeon/surgeon.capnp.h"
#include "surgeon/surgeon.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const SurgeonParametersSlot& slot, wire::SurgeonParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setAmplitude(slot.amplitude);
  out.setTurn(slot.turn);
  out.setFrequency(slot.frequency);
  out.setOpening(slot.opening);
  out.setRamp(slot.ramp);
}

suture::Errc fromWire(wire::SurgeonParameters::Reader in, SurgeonParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.amplitude = in.getAmplitude();
  slot.turn = in.getTurn();
  slot.frequency = in.getFrequency();
  slot.opening = in.getOpening();
  slot.ramp = in.getRamp();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SurgeonParameters& value) {
  return codec::encodeAs<robots::wire::SurgeonParameters, robots::SurgeonParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::SurgeonParameters& value) {
  return codec::decodeAs<robots::wire::SurgeonParameters,
                         robots::SurgeonParametersSlot>(bytes, value);
}

}  // namespace suture
