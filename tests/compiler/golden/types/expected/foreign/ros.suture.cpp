// Written by suturec from foreign/ros.h. Do not edit.
#include "foreign/ros.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "foreign/ros.capnp.h"

namespace foreign {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(ros::Time::sec), std::uint32_t>);
static_assert(std::is_same_v<decltype(ros::Time::nsec), std::uint32_t>);
static_assert(std::is_same_v<decltype(Header::seq), std::uint32_t>);
static_assert(std::is_same_v<decltype(Header::stamp), ros::Time>);
static_assert(std::is_same_v<decltype(Header::frame_id), std::string>);
static_assert(std::is_same_v<decltype(Point::x), double>);
static_assert(std::is_same_v<decltype(Point::y), double>);
static_assert(std::is_same_v<decltype(Point::z), double>);
static_assert(std::is_same_v<decltype(Quaternion::x), double>);
static_assert(std::is_same_v<decltype(Quaternion::y), double>);
static_assert(std::is_same_v<decltype(Quaternion::z), double>);
static_assert(std::is_same_v<decltype(Quaternion::w), double>);
static_assert(std::is_same_v<decltype(Pose::position), Point>);
static_assert(std::is_same_v<decltype(Pose::orientation), Quaternion>);
static_assert(std::is_same_v<decltype(PoseStamped::header), Header>);
static_assert(std::is_same_v<decltype(PoseStamped::pose), Pose>);
static_assert(std::is_same_v<decltype(JointState::header), Header>);
static_assert(std::is_same_v<decltype(JointState::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(JointState::position), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointState::velocity), std::vector<double>>);
static_assert(std::is_same_v<decltype(JointState::effort), std::vector<double>>);

}  // namespace

bool store(const ros::Time& value, rosTimeSlot& slot) {
  bool fits = true;
  fits &= store(value.sec, slot.sec);
  fits &= store(value.nsec, slot.nsec);
  return fits;
}

void load(const rosTimeSlot& slot, ros::Time& value) {
  load(slot.sec, value.sec);
  load(slot.nsec, value.nsec);
}

bool store(const Header& value, HeaderSlot& slot) {
  bool fits = true;
  fits &= store(value.seq, slot.seq);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.frame_id, slot.frame_id);
  return fits;
}

void load(const HeaderSlot& slot, Header& value) {
  load(slot.seq, value.seq);
  load(slot.stamp, value.stamp);
  load(slot.frame_id, value.frame_id);
}

void reserve(const HeaderSlot*, Header& value) {
  suture::reserveFor<decltype(HeaderSlot::frame_id)>(value.frame_id);
}

bool store(const Point& value, PointSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  return fits;
}

void load(const PointSlot& slot, Point& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
}

bool store(const Quaternion& value, QuaternionSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  fits &= store(value.z, slot.z);
  fits &= store(value.w, slot.w);
  return fits;
}

void load(const QuaternionSlot& slot, Quaternion& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
  load(slot.z, value.z);
  load(slot.w, value.w);
}

bool store(const Pose& value, PoseSlot& slot) {
  bool fits = true;
  fits &= store(value.position, slot.position);
  fits &= store(value.orientation, slot.orientation);
  return fits;
}

void load(const PoseSlot& slot, Pose& value) {
  load(slot.position, value.position);
  load(slot.orientation, value.orientation);
}

bool store(const PoseStamped& value, PoseStampedSlot& slot) {
  bool fits = true;
  fits &= store(value.header, slot.header);
  fits &= store(value.pose, slot.pose);
  return fits;
}

void load(const PoseStampedSlot& slot, PoseStamped& value) {
  load(slot.header, value.header);
  load(slot.pose, value.pose);
}

void reserve(const PoseStampedSlot*, PoseStamped& value) {
  suture::reserveFor<decltype(PoseStampedSlot::header)>(value.header);
}

bool store(const JointState& value, JointStateSlot& slot) {
  bool fits = true;
  fits &= store(value.header, slot.header);
  fits &= store(value.name, slot.name);
  fits &= store(value.position, slot.position);
  fits &= store(value.velocity, slot.velocity);
  fits &= store(value.effort, slot.effort);
  return fits;
}

void load(const JointStateSlot& slot, JointState& value) {
  load(slot.header, value.header);
  load(slot.name, value.name);
  load(slot.position, value.position);
  load(slot.velocity, value.velocity);
  load(slot.effort, value.effort);
}

void reserve(const JointStateSlot*, JointState& value) {
  suture::reserveFor<decltype(JointStateSlot::header)>(value.header);
  suture::reserveFor<decltype(JointStateSlot::name)>(value.name);
  suture::reserveFor<decltype(JointStateSlot::position)>(value.position);
  suture::reserveFor<decltype(JointStateSlot::velocity)>(value.velocity);
  suture::reserveFor<decltype(JointStateSlot::effort)>(value.effort);
}

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

bool isValid(const rosTimeSlot&, suture::FieldPath*) {
  return true;
}

void toWire(const HeaderSlot& slot, wire::Header::Builder out) {
  out.setSeq(slot.seq);
  toWire(slot.stamp, out.initStamp());
  toWire(slot.frame_id, out.initFrameId(sizeOf(slot.frame_id)));
}

suture::Errc fromWire(wire::Header::Reader in, HeaderSlot& slot, suture::Duration shift) {
  slot.seq = in.getSeq();
  return suture::rpc::firstError({
      in.hasStamp() ? fromWire(in.getStamp(), slot.stamp, shift)
          : suture::rpc::fromDefault(Header().stamp, slot.stamp),
      in.hasFrameId() ? fromWire(in.getFrameId(), slot.frame_id)
          : suture::rpc::fromDefault(Header().frame_id, slot.frame_id),
  });
}

bool isValid(const HeaderSlot& slot, suture::FieldPath* path) {
  return isValid(slot.stamp, path) || suture::refusedAt(path, "stamp");
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

bool isValid(const PointSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.x)) return suture::refusedAt(path, "x");
  if (!isValid(slot.y)) return suture::refusedAt(path, "y");
  return isValid(slot.z) || suture::refusedAt(path, "z");
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

bool isValid(const QuaternionSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.x)) return suture::refusedAt(path, "x");
  if (!isValid(slot.y)) return suture::refusedAt(path, "y");
  if (!isValid(slot.z)) return suture::refusedAt(path, "z");
  return isValid(slot.w) || suture::refusedAt(path, "w");
}

void toWire(const PoseSlot& slot, wire::Pose::Builder out) {
  toWire(slot.position, out.initPosition());
  toWire(slot.orientation, out.initOrientation());
}

suture::Errc fromWire(wire::Pose::Reader in, PoseSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      in.hasPosition() ? fromWire(in.getPosition(), slot.position, shift)
          : suture::rpc::fromDefault(Pose().position, slot.position),
      in.hasOrientation() ? fromWire(in.getOrientation(), slot.orientation, shift)
          : suture::rpc::fromDefault(Pose().orientation, slot.orientation),
  });
}

bool isValid(const PoseSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  return isValid(slot.orientation, path) || suture::refusedAt(path, "orientation");
}

void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out) {
  toWire(slot.header, out.initHeader());
  toWire(slot.pose, out.initPose());
}

suture::Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      in.hasHeader() ? fromWire(in.getHeader(), slot.header, shift)
          : suture::rpc::fromDefault(PoseStamped().header, slot.header),
      in.hasPose() ? fromWire(in.getPose(), slot.pose, shift)
          : suture::rpc::fromDefault(PoseStamped().pose, slot.pose),
  });
}

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.header, path)) return suture::refusedAt(path, "header");
  return isValid(slot.pose, path) || suture::refusedAt(path, "pose");
}

void toWire(const JointStateSlot& slot, wire::JointState::Builder out) {
  toWire(slot.header, out.initHeader());
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.position, out.initPosition(sizeOf(slot.position)));
  toWire(slot.velocity, out.initVelocity(sizeOf(slot.velocity)));
  toWire(slot.effort, out.initEffort(sizeOf(slot.effort)));
}

suture::Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      in.hasHeader() ? fromWire(in.getHeader(), slot.header, shift)
          : suture::rpc::fromDefault(JointState().header, slot.header),
      in.hasName() ? fromWire(in.getName(), slot.name)
          : suture::rpc::fromDefault(JointState().name, slot.name),
      in.hasPosition() ? fromWire(in.getPosition(), slot.position)
          : suture::rpc::fromDefault(JointState().position, slot.position),
      in.hasVelocity() ? fromWire(in.getVelocity(), slot.velocity)
          : suture::rpc::fromDefault(JointState().velocity, slot.velocity),
      in.hasEffort() ? fromWire(in.getEffort(), slot.effort)
          : suture::rpc::fromDefault(JointState().effort, slot.effort),
  });
}

bool isValid(const JointStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.header, path)) return suture::refusedAt(path, "header");
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

}  // namespace foreign

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const ros::Time& value) {
  return rpc::encodeAs<foreign::wire::Time, foreign::rosTimeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, ros::Time& value) {
  return rpc::decodeAs<foreign::wire::Time, foreign::rosTimeSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Header& value) {
  return rpc::encodeAs<foreign::wire::Header, foreign::HeaderSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Header& value) {
  return rpc::decodeAs<foreign::wire::Header, foreign::HeaderSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Point& value) {
  return rpc::encodeAs<foreign::wire::Point, foreign::PointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Point& value) {
  return rpc::decodeAs<foreign::wire::Point, foreign::PointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Quaternion& value) {
  return rpc::encodeAs<foreign::wire::Quaternion, foreign::QuaternionSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Quaternion& value) {
  return rpc::decodeAs<foreign::wire::Quaternion, foreign::QuaternionSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::Pose& value) {
  return rpc::encodeAs<foreign::wire::Pose, foreign::PoseSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::Pose& value) {
  return rpc::decodeAs<foreign::wire::Pose, foreign::PoseSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::PoseStamped& value) {
  return rpc::encodeAs<foreign::wire::PoseStamped, foreign::PoseStampedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::PoseStamped& value) {
  return rpc::decodeAs<foreign::wire::PoseStamped, foreign::PoseStampedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const foreign::JointState& value) {
  return rpc::encodeAs<foreign::wire::JointState, foreign::JointStateSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, foreign::JointState& value) {
  return rpc::decodeAs<foreign::wire::JointState, foreign::JointStateSlot>(bytes, value);
}

}  // namespace suture
