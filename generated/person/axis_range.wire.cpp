// Written by suturec from person/axis_range.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "person/axis_range.capnp.h"
#include "person/axis_range.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const AxisRangeSlot& slot, wire::AxisRange::Builder out) {
  out.setLowest(slot.lowest);
  out.setHighest(slot.highest);
}

suture::Errc fromWire(wire::AxisRange::Reader in, AxisRangeSlot& slot, suture::Duration) {
  slot.lowest = in.getLowest();
  slot.highest = in.getHighest();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AxisRange& value) {
  return codec::encodeAs<robots::wire::AxisRange, robots::AxisRangeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::AxisRange& value) {
  return codec::decodeAs<robots::wire::AxisRange, robots::AxisRangeSlot>(bytes, value);
}

}  // namespace suture
