// Written by suturec from vision/knot_tracker.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "vision/knot_tracker.capnp.h"
#include "vision/knot_tracker.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const TrackerParametersSlot& slot, wire::TrackerParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setMaxAge(slot.max_age);
  out.setAcceleration(slot.acceleration);
}

suture::Errc fromWire(wire::TrackerParameters::Reader in, TrackerParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.max_age = in.getMaxAge();
  slot.acceleration = in.getAcceleration();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::TrackerParameters& value) {
  return codec::encodeAs<robots::wire::TrackerParameters, robots::TrackerParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TrackerParameters& value) {
  return codec::decodeAs<robots::wire::TrackerParameters,
                         robots::TrackerParametersSlot>(bytes, value);
}

}  // namespace suture
