// Written by suturec from foreign/ros.h. Do not edit.
#include "foreign/ros.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace foreign {

using suture::isValid;
using suture::load;
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

bool isValid(const rosTimeSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const HeaderSlot& slot, suture::FieldPath* path) {
  return isValid(slot.stamp, path) || suture::refusedAt(path, "stamp");
}

bool isValid(const PointSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.x)) return suture::refusedAt(path, "x");
  if (!isValid(slot.y)) return suture::refusedAt(path, "y");
  return isValid(slot.z) || suture::refusedAt(path, "z");
}

bool isValid(const QuaternionSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.x)) return suture::refusedAt(path, "x");
  if (!isValid(slot.y)) return suture::refusedAt(path, "y");
  if (!isValid(slot.z)) return suture::refusedAt(path, "z");
  return isValid(slot.w) || suture::refusedAt(path, "w");
}

bool isValid(const PoseSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  return isValid(slot.orientation, path) || suture::refusedAt(path, "orientation");
}

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.header, path)) return suture::refusedAt(path, "header");
  return isValid(slot.pose, path) || suture::refusedAt(path, "pose");
}

bool isValid(const JointStateSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.header, path)) return suture::refusedAt(path, "header");
  if (!isValid(slot.position, path)) return suture::refusedAt(path, "position");
  if (!isValid(slot.velocity, path)) return suture::refusedAt(path, "velocity");
  return isValid(slot.effort, path) || suture::refusedAt(path, "effort");
}

}  // namespace foreign
