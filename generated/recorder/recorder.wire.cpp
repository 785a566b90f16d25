// Written by suturec from recorder/recorder.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "recorder/recorder.capnp.h"
#include "recorder/recorder.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const RecorderParametersSlot& slot, wire::RecorderParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
}

suture::Errc fromWire(wire::RecorderParameters::Reader in, RecorderParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return in.hasFile() ? fromWire(in.getFile(), slot.file)
      : suture::codec::fromDefault(RecorderParameters().file, slot.file);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::RecorderParameters& value) {
  return codec::encodeAs<robots::wire::RecorderParameters, robots::RecorderParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::RecorderParameters& value) {
  return codec::decodeAs<robots::wire::RecorderParameters,
                         robots::RecorderParametersSlot>(bytes, value);
}

}  // namespace suture
