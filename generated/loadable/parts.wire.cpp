// Written by suturec from loadable/parts.h. Do not edit.
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include "loadable/parts.capnp.h"
#include "loadable/parts.suture.h"

namespace loadable {

using suture::rpc::fromWire;
using suture::rpc::toWire;

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
  return suture::rpc::firstError({
      fromWire(in.getBrake(), slot.brake),
      fromWire(in.getKey(), slot.key),
  });
}

}  // namespace loadable

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const loadable::PlatterParameters& value) {
  return rpc::encodeAs<loadable::wire::PlatterParameters, loadable::PlatterParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, loadable::PlatterParameters& value) {
  return rpc::decodeAs<loadable::wire::PlatterParameters,
                       loadable::PlatterParametersSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const loadable::SpindleParameters& value) {
  return rpc::encodeAs<loadable::wire::SpindleParameters, loadable::SpindleParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, loadable::SpindleParameters& value) {
  return rpc::decodeAs<loadable::wire::SpindleParameters,
                       loadable::SpindleParametersSlot>(bytes, value);
}

}  // namespace suture
