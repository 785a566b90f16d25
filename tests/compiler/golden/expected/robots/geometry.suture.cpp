// Written by suturec from robots/geometry.h. Do not edit.
#include "robots/geometry.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robots/geometry.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(PoseStamped::pose), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(PoseStamped::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(PoseStamped::valid), bool>);

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

// --- between slots and Cap'n Proto

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

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseStamped& value) {
  return rpc::encodeAs<robots::wire::PoseStamped, robots::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseStamped& value) {
  return rpc::decodeAs<robots::wire::PoseStamped, robots::PoseStampedSlot>(bytes, value);
}

}  // namespace suture
