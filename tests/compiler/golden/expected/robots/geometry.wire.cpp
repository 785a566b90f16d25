// Written by suturec from robots/geometry.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robots/geometry.capnp.h"
#include "robots/geometry.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out) {
  toWire(slot.pose, out.initPose());
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.hasPose() ? fromWire(in.getPose(), slot.pose)
      : suture::codec::fromDefault(PoseStamped().pose, slot.pose);
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseStamped& value) {
  return codec::encodeAs<robots::wire::PoseStamped, robots::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseStamped& value) {
  return codec::decodeAs<robots::wire::PoseStamped, robots::PoseStampedSlot>(bytes, value);
}

}  // namespace suture
