// Written by suturec from robot_types/messages.h. Do not edit.
#include "robot_types/messages.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "robot_types/messages.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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
  slot.stamp = suture::rpc::shifted(slot.stamp, shift);
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

// --- between slots and Cap'n Proto

void toWire(const IntervalStatisticsSlot& slot, wire::IntervalStatistics::Builder out) {
  out.setPeriodAverage(slot.period_average);
  out.setPeriodDeviation(slot.period_deviation);
  out.setPeriodMin(slot.period_min);
  out.setPeriodMax(slot.period_max);
  out.setSamples(slot.samples);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

suture::Errc fromWire(wire::IntervalStatistics::Reader in, IntervalStatisticsSlot& slot,
                      suture::Duration shift) {
  slot.period_average = in.getPeriodAverage();
  slot.period_deviation = in.getPeriodDeviation();
  slot.period_min = in.getPeriodMin();
  slot.period_max = in.getPeriodMax();
  slot.samples = in.getSamples();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::Errc{};
}

bool isValid(const IntervalStatisticsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.period_average)) return suture::refusedAt(path, "period_average");
  if (!isValid(slot.period_deviation)) return suture::refusedAt(path, "period_deviation");
  if (!isValid(slot.period_min)) return suture::refusedAt(path, "period_min");
  return isValid(slot.period_max) || suture::refusedAt(path, "period_max");
}

void toWire(const KeyValueSlot& slot, wire::KeyValue::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}

suture::Errc fromWire(wire::KeyValue::Reader in, KeyValueSlot& slot, suture::Duration) {
  return suture::rpc::firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value),
  });
}

bool isValid(const KeyValueSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::IntervalStatistics& value) {
  return rpc::encodeAs<robots::wire::IntervalStatistics, robots::IntervalStatisticsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::IntervalStatistics& value) {
  return rpc::decodeAs<robots::wire::IntervalStatistics,
                       robots::IntervalStatisticsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::KeyValue& value) {
  return rpc::encodeAs<robots::wire::KeyValue, robots::KeyValueSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyValue& value) {
  return rpc::decodeAs<robots::wire::KeyValue, robots::KeyValueSlot>(bytes, value);
}

}  // namespace suture
