// Written by suturec from robot_types/pose.h. Do not edit.
#include "robot_types/pose.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
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
  slot.timestamp = suture::codec::shifted(slot.timestamp, shift);
}

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path) {
  return isValid(slot.pose) || suture::refusedAt(path, "pose");
}

bool isValid(const TransformStampedSlot& slot, suture::FieldPath* path) {
  return isValid(slot.transform) || suture::refusedAt(path, "transform");
}

bool isValid(const PoseSampleSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.rotation)) return suture::refusedAt(path, "rotation");
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

bool isValid(const PosePrmSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position) || suture::refusedAt(path, "position");
}

}  // namespace robots
