// Written by suturec from robot_types/pose.h. Do not edit.
#include "robot_types/pose.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/pose.capnp.h"

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
static_assert(std::is_same_v<decltype(TransformStamped::transform), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(TransformStamped::reference_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(TransformStamped::moving_frame), std::uint32_t>);
static_assert(std::is_same_v<decltype(TransformStamped::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(TransformStamped::valid), bool>);
static_assert(std::is_same_v<decltype(PoseSample::rotation), Eigen::Matrix3d>);
static_assert(std::is_same_v<decltype(PoseSample::position), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(PoseSample::stamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(PoseSample::sequence), std::uint64_t>);
static_assert(std::is_same_v<decltype(PoseSample::flags), std::uint64_t>);
static_assert(std::is_same_v<decltype(PosePrm::timestamp), std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(PosePrm::automatic_timestamp), bool>);
static_assert(std::is_same_v<decltype(PosePrm::valid), bool>);
static_assert(std::is_same_v<decltype(PosePrm::moving_frame), std::string>);
static_assert(std::is_same_v<decltype(PosePrm::reference_frame), std::string>);
static_assert(std::is_same_v<decltype(PosePrm::position), Eigen::Isometry3d>);

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

bool store(const TransformStamped& value, TransformStampedSlot& slot) {
  bool fits = true;
  fits &= store(value.transform, slot.transform);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const TransformStampedSlot& slot, TransformStamped& value) {
  load(slot.transform, value.transform);
  load(slot.reference_frame, value.reference_frame);
  load(slot.moving_frame, value.moving_frame);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(TransformStampedSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const PoseSample& value, PoseSampleSlot& slot) {
  bool fits = true;
  fits &= store(value.rotation, slot.rotation);
  fits &= store(value.position, slot.position);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.sequence, slot.sequence);
  fits &= store(value.flags, slot.flags);
  return fits;
}

void load(const PoseSampleSlot& slot, PoseSample& value) {
  load(slot.rotation, value.rotation);
  load(slot.position, value.position);
  load(slot.stamp, value.stamp);
  load(slot.sequence, value.sequence);
  load(slot.flags, value.flags);
}

void shiftStamps(PoseSampleSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
}

bool store(const PosePrm& value, PosePrmSlot& slot) {
  bool fits = true;
  fits &= store(value.timestamp, slot.timestamp);
  fits &= store(value.automatic_timestamp, slot.automatic_timestamp);
  fits &= store(value.valid, slot.valid);
  fits &= store(value.moving_frame, slot.moving_frame);
  fits &= store(value.reference_frame, slot.reference_frame);
  fits &= store(value.position, slot.position);
  return fits;
}

void load(const PosePrmSlot& slot, PosePrm& value) {
  load(slot.timestamp, value.timestamp);
  load(slot.automatic_timestamp, value.automatic_timestamp);
  load(slot.valid, value.valid);
  load(slot.moving_frame, value.moving_frame);
  load(slot.reference_frame, value.reference_frame);
  load(slot.position, value.position);
}

void reserve(const PosePrmSlot*, PosePrm& value) {
  suture::reserveFor<decltype(PosePrmSlot::moving_frame)>(value.moving_frame);
  suture::reserveFor<decltype(PosePrmSlot::reference_frame)>(value.reference_frame);
}

void shiftStamps(PosePrmSlot& slot, suture::Duration shift) {
  slot.timestamp = suture::rpc::shifted(slot.timestamp, shift);
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

void toWire(const TransformStampedSlot& slot, wire::TransformStamped::Builder out) {
  toWire(slot.transform, out.initTransform());
  out.setReferenceFrame(slot.reference_frame);
  out.setMovingFrame(slot.moving_frame);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::TransformStamped::Reader in, TransformStampedSlot& slot,
                      suture::Duration shift) {
  slot.reference_frame = in.getReferenceFrame();
  slot.moving_frame = in.getMovingFrame();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.hasTransform() ? fromWire(in.getTransform(), slot.transform)
      : suture::rpc::fromDefault(TransformStamped().transform, slot.transform);
}

bool isValid(const TransformStampedSlot& slot, suture::FieldPath* path) {
  return isValid(slot.transform) || suture::refusedAt(path, "transform");
}

void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out) {
  toWire(slot.rotation, out.initRotation());
  toWire(slot.position, out.initPosition());
  out.setStamp(slot.stamp);
  out.setSequence(slot.sequence);
  out.setFlags(slot.flags);
}

suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift) {
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.sequence = in.getSequence();
  slot.flags = in.getFlags();
  return suture::rpc::firstError({
      in.hasRotation() ? fromWire(in.getRotation(), slot.rotation)
          : suture::rpc::fromDefault(PoseSample().rotation, slot.rotation),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::rpc::fromDefault(PoseSample().position, slot.position),
  });
}

bool isValid(const PoseSampleSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.rotation)) return suture::refusedAt(path, "rotation");
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out) {
  out.setTimestamp(slot.timestamp);
  out.setAutomaticTimestamp(slot.automatic_timestamp != 0);
  out.setValid(slot.valid != 0);
  toWire(slot.moving_frame, out.initMovingFrame(sizeOf(slot.moving_frame)));
  toWire(slot.reference_frame, out.initReferenceFrame(sizeOf(slot.reference_frame)));
  toWire(slot.position, out.initPosition());
}

suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift) {
  slot.timestamp = suture::rpc::shifted(in.getTimestamp(), shift);
  slot.automatic_timestamp = in.getAutomaticTimestamp();
  slot.valid = in.getValid();
  return suture::rpc::firstError({
      fromWire(in.getMovingFrame(), slot.moving_frame),
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::rpc::fromDefault(PosePrm().position, slot.position),
  });
}

bool isValid(const PosePrmSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position) || suture::refusedAt(path, "position");
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

template <>
Result<std::vector<std::byte>> encode(const robots::TransformStamped& value) {
  return rpc::encodeAs<robots::wire::TransformStamped, robots::TransformStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TransformStamped& value) {
  return rpc::decodeAs<robots::wire::TransformStamped, robots::TransformStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::PoseSample& value) {
  return rpc::encodeAs<robots::wire::PoseSample, robots::PoseSampleSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseSample& value) {
  return rpc::decodeAs<robots::wire::PoseSample, robots::PoseSampleSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::PosePrm& value) {
  return rpc::encodeAs<robots::wire::PosePrm, robots::PosePrmSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PosePrm& value) {
  return rpc::decodeAs<robots::wire::PosePrm, robots::PosePrmSlot>(bytes, value);
}

}  // namespace suture
