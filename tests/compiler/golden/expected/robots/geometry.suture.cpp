// Written by suturec from robots/geometry.h. Do not edit.
#include "robots/geometry.suture.h"

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

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path) {
  return isValid(slot.pose) || suture::refusedAt(path, "pose");
}

}  // namespace robots
