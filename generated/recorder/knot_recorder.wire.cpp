// Written by suturec from recorder/knot_recorder.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "recorder/knot_recorder.capnp.h"
#include "recorder/knot_recorder.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const KnotRecorderParametersSlot& slot, wire::KnotRecorderParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
}

suture::Errc fromWire(wire::KnotRecorderParameters::Reader in, KnotRecorderParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return in.hasFile() ? fromWire(in.getFile(), slot.file)
      : suture::codec::fromDefault(KnotRecorderParameters().file, slot.file);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotRecorderParameters& value) {
  return codec::encodeAs<robots::wire::KnotRecorderParameters,
                         robots::KnotRecorderParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotRecorderParameters& value) {
  return codec::decodeAs<robots::wire::KnotRecorderParameters,
                         robots::KnotRecorderParametersSlot>(bytes, value);
}

}  // namespace suture
