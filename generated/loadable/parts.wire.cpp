// Written by suturec from loadable/parts.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "loadable/parts.capnp.h"
#include "loadable/parts.suture.h"

namespace loadable {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PlatterParametersSlot& slot, wire::PlatterParameters::Builder out) {
  out.setAngle(slot.angle);
}

suture::Errc fromWire(wire::PlatterParameters::Reader in, PlatterParametersSlot& slot,
                      suture::Duration) {
  slot.angle = in.getAngle();
  return suture::Errc{};
}

void toWire(const SpindleParametersSlot& slot, wire::SpindleParameters::Builder out) {
  out.setCycles(slot.cycles);
  toWire(slot.brake, out.initBrake(sizeOf(slot.brake)));
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
}

suture::Errc fromWire(wire::SpindleParameters::Reader in, SpindleParametersSlot& slot,
                      suture::Duration) {
  slot.cycles = in.getCycles();
  return suture::codec::firstError({
      fromWire(in.getBrake(), slot.brake),
      fromWire(in.getKey(), slot.key),
  });
}

}  // namespace loadable

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const loadable::PlatterParameters& value) {
  return codec::encodeAs<loadable::wire::PlatterParameters, loadable::PlatterParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, loadable::PlatterParameters& value) {
  return codec::decodeAs<loadable::wire::PlatterParameters,
                         loadable::PlatterParametersSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const loadable::SpindleParameters& value) {
  return codec::encodeAs<loadable::wire::SpindleParameters, loadable::SpindleParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, loadable::SpindleParameters& value) {
  return codec::decodeAs<loadable::wire::SpindleParameters,
                         loadable::SpindleParametersSlot>(bytes, value);
}

}  // namespace suture
