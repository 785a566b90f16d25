// Written by suturec from robot_types/messages.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/messages.h"

namespace robots {

/// Says how regularly a task ran, over its last window.
struct IntervalStatisticsSlot {
  double period_average;    // s
  double period_deviation;  // s
  double period_min;        // s
  double period_max;        // s
  std::uint32_t samples;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const IntervalStatistics& value, IntervalStatisticsSlot& slot);
void load(const IntervalStatisticsSlot& slot, IntervalStatistics& value);
void shiftStamps(IntervalStatisticsSlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmKeyValue.
struct KeyValueSlot {
  suture::BoundedText<31> key;
  suture::BoundedText<127> value;
};

bool store(const KeyValue& value, KeyValueSlot& slot);
void load(const KeyValueSlot& slot, KeyValue& value);
void reserve(const KeyValueSlot*, KeyValue& value);

bool isValid(const IntervalStatisticsSlot& slot, suture::FieldPath* path);
bool isValid(const KeyValueSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::IntervalStatistics& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::IntervalStatistics& value);

template <>
Result<std::vector<std::byte>> encode(const robots::KeyValue& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyValue& value);

}  // namespace suture
