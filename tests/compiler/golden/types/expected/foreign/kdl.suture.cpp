// Written by suturec from foreign/kdl.h. Do not edit.
#include "foreign/kdl.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "foreign/kdl.capnp.h"

namespace foreign {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(KDL::Vector::data), double[3]>);
static_assert(std::is_same_v<decltype(KDL::Rotation::data), double[9]>);
static_assert(std::is_same_v<decltype(KDL::Frame::p), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Frame::M), KDL::Rotation>);
static_assert(std::is_same_v<decltype(KDL::Twist::vel), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Twist::rot), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Wrench::force), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::Wrench::torque), KDL::Vector>);
static_assert(std::is_same_v<decltype(KDL::JntArray::data), Eigen::VectorXd>);
static_assert(std::is_same_v<decltype(Motion::frame), KDL::Frame>);
static_assert(std::is_same_v<decltype(Motion::twist), KDL::Twist>);
static_assert(std::is_same_v<decltype(Motion::wrench), KDL::Wrench>);
static_assert(std::is_same_v<decltype(Motion::joints), KDL::JntArray>);

}  // namespace

bool store(const KDL::Vector& value, KDLVectorSlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLVectorSlot& slot, KDL::Vector& value) {
  load(slot.data, value.data);
}

bool store(const KDL::Rotation& value, KDLRotationSlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLRotationSlot& slot, KDL::Rotation& value) {
  load(slot.data, value.data);
}

bool store(const KDL::Frame& value, KDLFrameSlot& slot) {
  bool fits = true;
  fits &= store(value.p, slot.p);
  fits &= store(value.M, slot.M);
  return fits;
}

void load(const KDLFrameSlot& slot, KDL::Frame& value) {
  load(slot.p, value.p);
  load(slot.M, value.M);
}

bool store(const KDL::Twist& value, KDLTwistSlot& slot) {
  bool fits = true;
  fits &= store(value.vel, slot.vel);
  fits &= store(value.rot, slot.rot);
  return fits;
}

void load(const KDLTwistSlot& slot, KDL::Twist& value) {
  load(slot.vel, value.vel);
  load(slot.rot, value.rot);
}

bool store(const KDL::Wrench& value, KDLWrenchSlot& slot) {
  bool fits = true;
  fits &= store(value.force, slot.force);
  fits &= store(value.torque, slot.torque);
  return fits;
}

void load(const KDLWrenchSlot& slot, KDL::Wrench& value) {
  load(slot.force, value.force);
  load(slot.torque, value.torque);
}

bool store(const KDL::JntArray& value, KDLJntArraySlot& slot) {
  bool fits = true;
  fits &= store(value.data, slot.data);
  return fits;
}

void load(const KDLJntArraySlot& slot, KDL::JntArray& value) {
  load(slot.data, value.data);
}

bool store(const Motion& value, MotionSlot& slot) {
  bool fits = true;
  fits &= store(value.frame, slot.frame);
  fits &= store(value.twist, slot.twist);
  fits &= store(value.wrench, slot.wrench);
  fits &= store(value.joints, slot.joints);
  return fits;
}

void load(const MotionSlot& slot, Motion& value) {
  load(slot.frame, value.frame);
  load(slot.twist, value.twist);
  load(slot.wrench, value.wrench);
  load(slot.joints, value.joints);
}

// --- between slots and Cap'n Proto

void toWire(const KDLVectorSlot& slot, wire::Vector::Builder out) {
  toWire(slot.data, out.initData(3));
}

suture::Errc fromWire(wire::Vector::Reader in, KDLVectorSlot& slot, suture::Duration) {
  return in.getData().size() != 0 ? fromWire(in.getData(), slot.data)
      : suture::rpc::fromDefault(KDL::Vector().data, slot.data);
}

bool isValid(const KDLVectorSlot& slot, suture::FieldPath* path) {
  return isValid(slot.data, path) || suture::refusedAt(path, "data");
}

void toWire(const KDLRotationSlot& slot, wire::Rotation::Builder out) {
  toWire(slot.data, out.initData(9));
}

suture::Errc fromWire(wire::Rotation::Reader in, KDLRotationSlot& slot, suture::Duration) {
  return in.getData().size() != 0 ? fromWire(in.getData(), slot.data)
      : suture::rpc::fromDefault(KDL::Rotation().data, slot.data);
}

bool isValid(const KDLRotationSlot& slot, suture::FieldPath* path) {
  return isValid(slot.data, path) || suture::refusedAt(path, "data");
}

void toWire(const KDLFrameSlot& slot, wire::Frame::Builder out) {
  toWire(slot.p, out.initP());
  toWire(slot.M, out.initM());
}

suture::Errc fromWire(wire::Frame::Reader in, KDLFrameSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getP(), slot.p, shift),
      fromWire(in.getM(), slot.M, shift),
  });
}

bool isValid(const KDLFrameSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.p, path)) return suture::refusedAt(path, "p");
  return isValid(slot.M, path) || suture::refusedAt(path, "M");
}

void toWire(const KDLTwistSlot& slot, wire::Twist::Builder out) {
  toWire(slot.vel, out.initVel());
  toWire(slot.rot, out.initRot());
}

suture::Errc fromWire(wire::Twist::Reader in, KDLTwistSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getVel(), slot.vel, shift),
      fromWire(in.getRot(), slot.rot, shift),
  });
}

bool isValid(const KDLTwistSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.vel, path)) return suture::refusedAt(path, "vel");
  return isValid(slot.rot, path) || suture::refusedAt(path, "rot");
}

void toWire(const KDLWrenchSlot& slot, wire::Wrench::Builder out) {
  toWire(slot.force, out.initForce());
  toWire(slot.torque, out.initTorque());
}

suture::Errc fromWire(wire::Wrench::Reader in, KDLWrenchSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getForce(), slot.force, shift),
      fromWire(in.getTorque(), slot.torque, shift),
  });
}

bool isValid(const KDLWrenchSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.force, path)) return suture::refusedAt(path, "force");
  return isValid(slot.torque, path) || suture::refusedAt(path, "torque");
}

void toWire(const KDLJntArraySlot& slot, wire::Joints::Builder out) {
  toWire(slot.data, out.initData(sizeOf(slot.data)));
}

suture::Errc fromWire(wire::Joints::Reader in, KDLJntArraySlot& slot, suture::Duration) {
  return in.hasData() ? fromWire(in.getData(), slot.data)
      : suture::rpc::fromDefault(KDL::JntArray().data, slot.data);
}

bool isValid(const KDLJntArraySlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::allOf(slot.data, path, [](const double& element) {
    return suture::rpc::inRange(element, -6.5, 6.5);
  })) {
    return suture::refusedAt(path, "data");
  }
  return true;
}

void toWire(const MotionSlot& slot, wire::Motion::Builder out) {
  toWire(slot.frame, out.initFrame());
  toWire(slot.twist, out.initTwist());
  toWire(slot.wrench, out.initWrench());
  toWire(slot.joints, out.initJoints());
}

suture::Errc fromWire(wire::Motion::Reader in, MotionSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getFrame(), slot.frame, shift),
      fromWire(in.getTwist(), slot.twist, shift),
      fromWire(in.getWrench(), slot.wrench, shift),
      fromWire(in.getJoints(), slot.joints, shift),
  });
}

bool isValid(const MotionSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.frame, path)) return suture::refusedAt(path, "frame");
  if (!isValid(slot.twist, path)) return suture::refusedAt(path, "twist");
  if (!isValid(slot.wrench, path)) return suture::refusedAt(path, "wrench");
  return isValid(slot.joints, path) || suture::refusedAt(path, "joints");
}

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const KDL::Vector& value) {
  return rpc::encodeAs<foreign::wire::Vector, foreign::KDLVectorSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Vector& value) {
  return rpc::decodeAs<foreign::wire::Vector, foreign::KDLVectorSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Rotation& value) {
  return rpc::encodeAs<foreign::wire::Rotation, foreign::KDLRotationSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Rotation& value) {
  return rpc::decodeAs<foreign::wire::Rotation, foreign::KDLRotationSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Frame& value) {
  return rpc::encodeAs<foreign::wire::Frame, foreign::KDLFrameSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Frame& value) {
  return rpc::decodeAs<foreign::wire::Frame, foreign::KDLFrameSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Twist& value) {
  return rpc::encodeAs<foreign::wire::Twist, foreign::KDLTwistSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Twist& value) {
  return rpc::decodeAs<foreign::wire::Twist, foreign::KDLTwistSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::Wrench& value) {
  return rpc::encodeAs<foreign::wire::Wrench, foreign::KDLWrenchSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::Wrench& value) {
  return rpc::decodeAs<foreign::wire::Wrench, foreign::KDLWrenchSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const KDL::JntArray& value) {
  return rpc::encodeAs<foreign::wire::Joints, foreign::KDLJntArraySlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, KDL::JntArray& value) {
  return rpc::decodeAs<foreign::wire::Joints, foreign::KDLJntArraySlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Motion& value) {
  return rpc::encodeAs<foreign::wire::Motion, foreign::MotionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Motion& value) {
  return rpc::decodeAs<foreign::wire::Motion, foreign::MotionSlot>(bytes, value);
}

}  // namespace suture
