// Written by suturec from robots/geometry.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robots/geometry.h"

namespace robots {

/// A pose with its time.
struct PoseStampedSlot {
  std::array<double, 12> pose;  // Eigen::Isometry3d
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

bool store(const PoseStamped& value, PoseStampedSlot& slot);
void load(const PoseStampedSlot& slot, PoseStamped& value);
void shiftStamps(PoseStampedSlot& slot, suture::Duration shift);

bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PoseStamped& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PoseStamped& value);

}  // namespace suture
