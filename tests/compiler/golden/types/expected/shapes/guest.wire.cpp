// Written by suturec from shapes/guest.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/guest.capnp.h"
#include "shapes/guest.suture.h"

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const guestLimitsSlot& slot, wire::Limits::Builder out) {
  out.setLow(slot.low);
  out.setHigh(slot.high);
}

suture::Errc fromWire(wire::Limits::Reader in, guestLimitsSlot& slot, suture::Duration) {
  slot.low = in.getLow();
  slot.high = in.getHigh();
  return suture::Errc{};
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const guest::Limits& value) {
  return codec::encodeAs<shapes::wire::Limits, shapes::guestLimitsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, guest::Limits& value) {
  return codec::decodeAs<shapes::wire::Limits, shapes::guestLimitsSlot>(bytes, value);
}

}  // namespace suture
