// Written by suturec from reference/arm_types.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "reference/arm_types.h"

namespace reference {

/// A pose with its time.
struct PoseStampedSlot {
  std::array<double, 12> pose;  // Eigen::Isometry3d, m
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

bool store(const PoseStamped& value, PoseStampedSlot& slot);
void load(const PoseStampedSlot& slot, PoseStamped& value);
void shiftStamps(PoseStampedSlot& slot, suture::Duration shift);

struct JointStateSlot {
  suture::BoundedList<suture::BoundedText<15>, 8> name;
  suture::BoundedList<double, 8> position;  // rad
};

bool store(const JointState& value, JointStateSlot& slot);
void load(const JointStateSlot& slot, JointState& value);
void reserve(const JointStateSlot*, JointState& value);

bool isKnownMode(std::uint8_t slot);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path);

}  // namespace reference

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const reference::PoseStamped& value);
template <>
Result<> decode(std::span<const std::byte> bytes, reference::PoseStamped& value);

template <>
Result<std::vector<std::byte>> encode(const reference::JointState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, reference::JointState& value);

}  // namespace suture
