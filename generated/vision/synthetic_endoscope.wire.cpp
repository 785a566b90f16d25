// Written by suturec from vision/synthetic_endoscope.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "vision/synthetic_endoscope.capnp.h"
#include "vision/synthetic_endoscope.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const EndoscopeParametersSlot& slot, wire::EndoscopeParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setNoise(slot.noise);
  out.setBlur(slot.blur);
  out.setDropout(slot.dropout);
  out.setLatency(slot.latency);
  out.setVergence(slot.vergence);
}

suture::Errc fromWire(wire::EndoscopeParameters::Reader in, EndoscopeParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.noise = in.getNoise();
  slot.blur = in.getBlur();
  slot.dropout = in.getDropout();
  slot.latency = in.getLatency();
  slot.vergence = in.getVergence();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::EndoscopeParameters& value) {
  return codec::encodeAs<robots::wire::EndoscopeParameters, robots::EndoscopeParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::EndoscopeParameters& value) {
  return codec::decodeAs<robots::wire::EndoscopeParameters,
                         robots::EndoscopeParametersSlot>(bytes, value);
}

}  // namespace suture
