// Written by suturec from reference/arm_types.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "reference/arm_types.capnp.h"
#include "reference/arm_types.suture.h"

namespace reference {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Mode wireMode(std::uint8_t slot) {
  switch (static_cast<Mode>(slot)) {
    case Mode::Disabled: return wire::Mode::DISABLED;
    case Mode::Enabled: return wire::Mode::ENABLED;
  }
  return wire::Mode{};
}

suture::Errc fromWire(wire::Mode in, std::uint8_t& slot) {
  switch (in) {
    case wire::Mode::DISABLED: return slot =
        static_cast<std::uint8_t>(Mode::Disabled), suture::Errc{};
    case wire::Mode::ENABLED: return slot =
        static_cast<std::uint8_t>(Mode::Enabled), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

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

void toWire(const JointStateSlot& slot, wire::JointState::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
}

suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration) {
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getPosition(), slot.position),
  });
}

}  // namespace reference

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const reference::PoseStamped& value) {
  return codec::encodeAs<reference::wire::PoseStamped, reference::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, reference::PoseStamped& value) {
  return codec::decodeAs<reference::wire::PoseStamped, reference::PoseStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const reference::JointState& value) {
  return codec::encodeAs<reference::wire::JointState, reference::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, reference::JointState& value) {
  return codec::decodeAs<reference::wire::JointState, reference::JointStateSlot>(bytes, value);
}

}  // namespace suture
