// Written by suturec from robot_types/messages.h. Do not edit.
#include "robot_types/messages.suture.h"

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
static_assert(std::is_same_v<decltype(IntervalStatistics::period_average), double>);
static_assert(std::is_same_v<decltype(IntervalStatistics::period_deviation), double>);
static_assert(std::is_same_v<decltype(IntervalStatistics::period_min), double>);
static_assert(std::is_same_v<decltype(IntervalStatistics::period_max), double>);
static_assert(std::is_same_v<decltype(IntervalStatistics::samples), std::uint32_t>);
static_assert(std::is_same_v<decltype(IntervalStatistics::stamp),
                             std::chrono::steady_clock::time_point>);
static_assert(std::is_same_v<decltype(IntervalStatistics::valid), bool>);
static_assert(std::is_same_v<decltype(KeyValue::key), std::string>);
static_assert(std::is_same_v<decltype(KeyValue::value), std::string>);

}  // namespace

bool store(const IntervalStatistics& value, IntervalStatisticsSlot& slot) {
  bool fits = true;
  fits &= store(value.period_average, slot.period_average);
  fits &= store(value.period_deviation, slot.period_deviation);
  fits &= store(value.period_min, slot.period_min);
  fits &= store(value.period_max, slot.period_max);
  fits &= store(value.samples, slot.samples);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

void load(const IntervalStatisticsSlot& slot, IntervalStatistics& value) {
  load(slot.period_average, value.period_average);
  load(slot.period_deviation, value.period_deviation);
  load(slot.period_min, value.period_min);
  load(slot.period_max, value.period_max);
  load(slot.samples, value.samples);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

void shiftStamps(IntervalStatisticsSlot& slot, suture::Duration shift) {
  slot.stamp = suture::codec::shifted(slot.stamp, shift);
}

bool store(const KeyValue& value, KeyValueSlot& slot) {
  bool fits = true;
  fits &= store(value.key, slot.key);
  fits &= store(value.value, slot.value);
  return fits;
}

void load(const KeyValueSlot& slot, KeyValue& value) {
  load(slot.key, value.key);
  load(slot.value, value.value);
}

void reserve(const KeyValueSlot*, KeyValue& value) {
  suture::reserveFor<decltype(KeyValueSlot::key)>(value.key);
  suture::reserveFor<decltype(KeyValueSlot::value)>(value.value);
}

bool isValid(const IntervalStatisticsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.period_average)) return suture::refusedAt(path, "period_average");
  if (!isValid(slot.period_deviation)) return suture::refusedAt(path, "period_deviation");
  if (!isValid(slot.period_min)) return suture::refusedAt(path, "period_min");
  return isValid(slot.period_max) || suture::refusedAt(path, "period_max");
}

bool isValid(const KeyValueSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots
