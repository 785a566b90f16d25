// Written by suturec from robot_types/pose.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/pose.capnp.h"
#include "robot_types/pose.suture.h"

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
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return in.hasTransform() ? fromWire(in.getTransform(), slot.transform)
      : suture::codec::fromDefault(TransformStamped().transform, slot.transform);
}

void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out) {
  toWire(slot.rotation, out.initRotation());
  toWire(slot.position, out.initPosition());
  out.setStamp(slot.stamp);
  out.setSequence(slot.sequence);
  out.setFlags(slot.flags);
}

suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.sequence = in.getSequence();
  slot.flags = in.getFlags();
  return suture::codec::firstError({
      in.hasRotation() ? fromWire(in.getRotation(), slot.rotation)
          : suture::codec::fromDefault(PoseSample().rotation, slot.rotation),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::codec::fromDefault(PoseSample().position, slot.position),
  });
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
  slot.timestamp = suture::codec::shifted(in.getTimestamp(), shift);
  slot.automatic_timestamp = in.getAutomaticTimestamp();
  slot.valid = in.getValid();
  return suture::codec::firstError({
      fromWire(in.getMovingFrame(), slot.moving_frame),
      fromWire(in.getReferenceFrame(), slot.reference_frame),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::codec::fromDefault(PosePrm().position, slot.position),
  });
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

template <>
Result<std::vector<std::byte>> encode(const robots::TransformStamped& value) {
  return codec::encodeAs<robots::wire::TransformStamped, robots::TransformStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TransformStamped& value) {
  return codec::decodeAs<robots::wire::TransformStamped,
                         robots::TransformStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::PoseSample& value) {
  return codec::encodeAs<robots::wire::PoseSample, robots::PoseSampleSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseSample& value) {
  return codec::decodeAs<robots::wire::PoseSample, robots::PoseSampleSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::PosePrm& value) {
  return codec::encodeAs<robots::wire::PosePrm, robots::PosePrmSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PosePrm& value) {
  return codec::decodeAs<robots::wire::PosePrm, robots::PosePrmSlot>(bytes, value);
}

}  // namespace suture
