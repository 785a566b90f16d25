// Written by suturec from foreign/kdl.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "foreign/kdl.capnp.h"
#include "foreign/kdl.suture.h"

namespace foreign {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const KDLVectorSlot& slot, wire::Vector::Builder out) {
  toWire(slot.data, out.initData(3));
}

suture::Errc fromWire(wire::Vector::Reader in, KDLVectorSlot& slot, suture::Duration) {
  return in.getData().size() != 0 ? fromWire(in.getData(), slot.data)
      : suture::codec::fromDefault(KDL::Vector().data, slot.data);
}

void toWire(const KDLRotationSlot& slot, wire::Rotation::Builder out) {
  toWire(slot.data, out.initData(9));
}

suture::Errc fromWire(wire::Rotation::Reader in, KDLRotationSlot& slot, suture::Duration) {
  return in.getData().size() != 0 ? fromWire(in.getData(), slot.data)
      : suture::codec::fromDefault(KDL::Rotation().data, slot.data);
}

void toWire(const KDLFrameSlot& slot, wire::Frame::Builder out) {
  toWire(slot.p, out.initP());
  toWire(slot.M, out.initM());
}

suture::Errc fromWire(wire::Frame::Reader in, KDLFrameSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getP(), slot.p, shift),
      fromWire(in.getM(), slot.M, shift),
  });
}

void toWire(const KDLTwistSlot& slot, wire::Twist::Builder out) {
  toWire(slot.vel, out.initVel());
  toWire(slot.rot, out.initRot());
}

suture::Errc fromWire(wire::Twist::Reader in, KDLTwistSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getVel(), slot.vel, shift),
      fromWire(in.getRot(), slot.rot, shift),
  });
}

void toWire(const KDLWrenchSlot& slot, wire::Wrench::Builder out) {
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
}

suture::Errc fromWire(wire::Wrench::Reader in, KDLWrenchSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getForce(), slot.force, shift),
      fromWire(in.getTorque(), slot.torque, shift),
  });
}

void toWire(const KDLJntArraySlot& slot, wire::Joints::Builder out) {
  toWire(slot.data, out.initData(sizeOf(slot.data)));
}

suture::Errc fromWire(wire::Joints::Reader in, KDLJntArraySlot& slot, suture::Duration) {
  return in.hasData() ? fromWire(in.getData(), slot.data)
      : suture::codec::fromDefault(KDL::JntArray().data, slot.data);
}

void toWire(const MotionSlot& slot, wire::Motion::Builder out) {
  toWire(slot.frame, out.initFrame());
  toWire(slot.twist, out.initTwist());
  toWire(slot.wrench, out.initWrench());
  toWire(slot.joints, out.initJoints());
}

suture::Errc fromWire(wire::Motion::Reader in, MotionSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getFrame(), slot.frame, shift),
      fromWire(in.getTwist(), slot.twist, shift),
      fromWire(in.getWrench(), slot.wrench, shift),
      fromWire(in.getJoints(), slot.joints, shift),
  });
}

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const KDL::Vector& value) {
  return codec::encodeAs<foreign::wire::Vector, foreign::KDLVectorSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Vector& value) {
  return codec::decodeAs<foreign::wire::Vector, foreign::KDLVectorSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Rotation& value) {
  return codec::encodeAs<foreign::wire::Rotation, foreign::KDLRotationSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Rotation& value) {
  return codec::decodeAs<foreign::wire::Rotation, foreign::KDLRotationSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Frame& value) {
  return codec::encodeAs<foreign::wire::Frame, foreign::KDLFrameSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Frame& value) {
  return codec::decodeAs<foreign::wire::Frame, foreign::KDLFrameSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Twist& value) {
  return codec::encodeAs<foreign::wire::Twist, foreign::KDLTwistSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Twist& value) {
  return codec::decodeAs<foreign::wire::Twist, foreign::KDLTwistSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Wrench& value) {
  return codec::encodeAs<foreign::wire::Wrench, foreign::KDLWrenchSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Wrench& value) {
  return codec::decodeAs<foreign::wire::Wrench, foreign::KDLWrenchSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::JntArray& value) {
  return codec::encodeAs<foreign::wire::Joints, foreign::KDLJntArraySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::JntArray& value) {
  return codec::decodeAs<foreign::wire::Joints, foreign::KDLJntArraySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Motion& value) {
  return codec::encodeAs<foreign::wire::Motion, foreign::MotionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Motion& value) {
  return codec::decodeAs<foreign::wire::Motion, foreign::MotionSlot>(bytes, value);
}

}  // namespace suture
