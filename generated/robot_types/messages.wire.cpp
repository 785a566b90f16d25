// Written by suturec from robot_types/messages.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "robot_types/messages.capnp.h"
#include "robot_types/messages.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

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
  slot.stamp = suture::codec::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return suture::Errc{};
}

void toWire(const KeyValueSlot& slot, wire::KeyValue::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}

suture::Errc fromWire(wire::KeyValue::Reader in, KeyValueSlot& slot, suture::Duration) {
  return suture::codec::firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::IntervalStatistics& value) {
  return codec::encodeAs<robots::wire::IntervalStatistics, robots::IntervalStatisticsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::IntervalStatistics& value) {
  return codec::decodeAs<robots::wire::IntervalStatistics,
                         robots::IntervalStatisticsSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const robots::KeyValue& value) {
  return codec::encodeAs<robots::wire::KeyValue, robots::KeyValueSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyValue& value) {
  return codec::decodeAs<robots::wire::KeyValue, robots::KeyValueSlot>(bytes, value);
}

}  // namespace suture
