// Written by suturec from foreign/ros.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "foreign/ros.capnp.h"
#include "foreign/ros.suture.h"

namespace foreign {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const rosTimeSlot& slot, wire::Time::Builder out) {
  out.setSec(slot.sec);
  out.setNsec(slot.nsec);
}

suture::Errc fromWire(wire::Time::Reader in, rosTimeSlot& slot, suture::Duration) {
  slot.sec = in.getSec();
  slot.nsec = in.getNsec();
  return suture::Errc{};
}

void toWire(const HeaderSlot& slot, wire::Header::Builder out) {
  out.setSeq(slot.seq);
  toWire(slot.stamp, out.initStamp());
  toWire(slot.frame_id, out.initFrameId(sizeOf(slot.frame_id)));
}

suture::Errc fromWire(wire::Header::Reader in, HeaderSlot& slot, suture::Duration shift) {
  slot.seq = in.getSeq();
  return suture::codec::firstError({
      in.hasStamp() ? fromWire(in.getStamp(), slot.stamp, shift)
          : suture::codec::fromDefault(Header().stamp, slot.stamp),
      in.hasFrameId() ? fromWire(in.getFrameId(), slot.frame_id)
          : suture::codec::fromDefault(Header().frame_id, slot.frame_id),
  });
}

void toWire(const PointSlot& slot, wire::Point::Builder out) {
  out.setX(slot.x);
  out.setY(slot.y);
  out.setZ(slot.z);
}

suture::Errc fromWire(wire::Point::Reader in, PointSlot& slot, suture::Duration) {
  slot.x = in.getX();
  slot.y = in.getY();
  slot.z = in.getZ();
  return suture::Errc{};
}

void toWire(const QuaternionSlot& slot, wire::Quaternion::Builder out) {
  out.setX(slot.x);
  out.setY(slot.y);
  out.setZ(slot.z);
  out.setW(slot.w);
}

suture::Errc fromWire(wire::Quaternion::Reader in, QuaternionSlot& slot, suture::Duration) {
  slot.x = in.getX();
  slot.y = in.getY();
  slot.z = in.getZ();
  slot.w = in.getW();
  return suture::Errc{};
}

void toWire(const PoseSlot& slot, wire::Pose::Builder out) {
  toWire(slot.position, out.initPosition());
  toWire(slot.orientation, out.initOrientation());
}

suture::Errc fromWire(wire::Pose::Reader in, PoseSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      in.hasPosition() ? fromWire(in.getPosition(), slot.position, shift)
          : suture::codec::fromDefault(Pose().position, slot.position),
      in.hasOrientation() ? fromWire(in.getOrientation(), slot.orientation, shift)
          : suture::codec::fromDefault(Pose().orientation, slot.orientation),
  });
}

void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out) {
  toWire(slot.header, out.initHeader());
  toWire(slot.pose, out.initPose());
}

suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      in.hasHeader() ? fromWire(in.getHeader(), slot.header, shift)
          : suture::codec::fromDefault(PoseStamped().header, slot.header),
      in.hasPose() ? fromWire(in.getPose(), slot.pose, shift)
          : suture::codec::fromDefault(PoseStamped().pose, slot.pose),
  });
}

void toWire(const JointStateSlot& slot, wire::JointState::Builder out) {
  toWire(slot.header, out.initHeader());
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  toWire(slot.effort, out.initEffort(sizeOf(slot.effort)));
}

suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      in.hasHeader() ? fromWire(in.getHeader(), slot.header, shift)
          : suture::codec::fromDefault(JointState().header, slot.header),
      in.hasName() ? fromWire(in.getName(), slot.name)
          : suture::codec::fromDefault(JointState().name, slot.name),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::codec::fromDefault(JointState().position, slot.position),
      in.hasVelocity() ? fromWire(in.getVelocity(), slot.velocity)
          : suture::codec::fromDefault(JointState().velocity, slot.velocity),
      in.hasEffort() ? fromWire(in.getEffort(), slot.effort)
          : suture::codec::fromDefault(JointState().effort, slot.effort),
  });
}

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const ros::Time& value) {
  return codec::encodeAs<foreign::wire::Time, foreign::rosTimeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, ros::Time& value) {
  return codec::decodeAs<foreign::wire::Time, foreign::rosTimeSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Header& value) {
  return codec::encodeAs<foreign::wire::Header, foreign::HeaderSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Header& value) {
  return codec::decodeAs<foreign::wire::Header, foreign::HeaderSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Point& value) {
  return codec::encodeAs<foreign::wire::Point, foreign::PointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Point& value) {
  return codec::decodeAs<foreign::wire::Point, foreign::PointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Quaternion& value) {
  return codec::encodeAs<foreign::wire::Quaternion, foreign::QuaternionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Quaternion& value) {
  return codec::decodeAs<foreign::wire::Quaternion, foreign::QuaternionSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Pose& value) {
  return codec::encodeAs<foreign::wire::Pose, foreign::PoseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Pose& value) {
  return codec::decodeAs<foreign::wire::Pose, foreign::PoseSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::PoseStamped& value) {
  return codec::encodeAs<foreign::wire::PoseStamped, foreign::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::PoseStamped& value) {
  return codec::decodeAs<foreign::wire::PoseStamped, foreign::PoseStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::JointState& value) {
  return codec::encodeAs<foreign::wire::JointState, foreign::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::JointState& value) {
  return codec::decodeAs<foreign::wire::JointState, foreign::JointStateSlot>(bytes, value);
}

}  // namespace suture
