// Written by suturec from person/axis_range.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "person/axis_range.h"

namespace robots {

/// Holds what an absolute axis of an input device says at its two ends. `evtest` prints it.
struct AxisRangeSlot {
  std::int32_t lowest;
  std::int32_t highest;
};

bool store(const AxisRange& value, AxisRangeSlot& slot);
void load(const AxisRangeSlot& slot, AxisRange& value);

bool isValid(const AxisRangeSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AxisRange& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::AxisRange& value);

}  // namespace suture
