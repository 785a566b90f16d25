// Written by suturec from reference/arm_types.h. Do not edit.
#include "reference/arm_types.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "reference/arm_types.capnp.h"

namespace reference {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Mode>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Mode::Disabled) == 0);
static_assert(static_cast<std::uint8_t>(Mode::Enabled) == 1);
static_assert(std::is_same_v<decltype(PoseStamped::pose), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(PoseStamped::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(PoseStamped::valid), bool>);
static_assert(std::is_same_v<decltype(JointState::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(JointState::position), std::vector<double>>);

}  // namespace

bool store(const PoseStamped& value, PoseStampedSlot& slot) {
  bool fits = true;
  fits &= store(value.pose, slot.pose);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const PoseStampedSlot& slot, PoseStamped& value) {
  load(slot.pose, value.pose);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(PoseStampedSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const JointState& value, JointStateSlot& slot) {
  bool fits = true;
  fits &= store(value.name, slot.name);
  fits &= store(value.position, slot.position);
  return fits;
}

void load(const JointStateSlot& slot, JointState& value) {
  load(slot.name, value.name);
  load(slot.position, value.position);
}

void reserve(const JointStateSlot*, JointState& value) {
  suture::reserveFor<decltype(JointStateSlot::name)>(value.name);
  suture::reserveFor<decltype(JointStateSlot::position)>(value.position);
}

// --- between slots and Cap'n Proto

wire::Mode wireMode(std::uint8_t slot) {
  switch (static_cast<Mode>(slot)) {
    case Mode::Disabled: return wire::Mode::DISABLED;
    case Mode::Enabled: return wire::Mode::ENABLED;
  }
  return wire::Mode{};
}

bool isKnownMode(std::uint8_t slot) {
  switch (static_cast<Mode>(slot)) {
    case Mode::Disabled:
    case Mode::Enabled:
      return true;
  }
  return false;
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
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.hasPose() ? fromWire(in.getPose(), slot.pose)
      : suture::rpc::fromDefault(PoseStamped().pose, slot.pose);
}

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path) {
  return isValid(slot.pose) || suture::refusedAt(path, "pose");
}

void toWire(const JointStateSlot& slot, wire::JointState::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
}

suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration) {
  return suture::rpc::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getPosition(), slot.position),
  });
}

bool isValid(const JointStateSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

}  // namespace reference

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const reference::PoseStamped& value) {
  return rpc::encodeAs<reference::wire::PoseStamped, reference::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, reference::PoseStamped& value) {
  return rpc::decodeAs<reference::wire::PoseStamped, reference::PoseStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const reference::JointState& value) {
  return rpc::encodeAs<reference::wire::JointState, reference::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, reference::JointState& value) {
  return rpc::decodeAs<reference::wire::JointState, reference::JointStateSlot>(bytes, value);
}

}  // namespace suture
