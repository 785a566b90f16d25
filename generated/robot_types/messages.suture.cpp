// Written by suturec from robot_types/messages.h. Do not edit.
#include "robot_types/messages.suture.h"

#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "robot_types/messages.capnp.h"

namespace robots {

using suture::Duration;
using suture::Errc;
using suture::rpc::allOf;
using suture::rpc::firstError;
using suture::rpc::fromWire;
using suture::rpc::fromWireList;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::rpc::toWireList;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Message::text), std::string>);
static_assert(std::is_same_v<decltype(Message::counter), std::uint32_t>);
static_assert(std::is_same_v<decltype(Message::stamp), std::chrono::steady_clock::time_point>);
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

// --- between slots and Cap'n Proto

void toWire(const MessageSlot& slot, wire::Message::Builder out) {
  toWire(slot.text, out.initText(slot.text.size));
  out.setCounter(slot.counter);
  out.setStamp(slot.stamp);
}

Errc fromWire(wire::Message::Reader in, MessageSlot& slot, Duration shift) {
  slot.counter = in.getCounter();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  return fromWire(in.getText(), slot.text);
}

bool isValid(const MessageSlot&) {
  return true;
}

void toWire(const IntervalStatisticsSlot& slot, wire::IntervalStatistics::Builder out) {
  out.setPeriodAverage(slot.period_average);
  out.setPeriodDeviation(slot.period_deviation);
  out.setPeriodMin(slot.period_min);
  out.setPeriodMax(slot.period_max);
  out.setSamples(slot.samples);
  out.setStamp(slot.stamp);
  out.setValid(slot.valid != 0);
}

Errc fromWire(wire::IntervalStatistics::Reader in, IntervalStatisticsSlot& slot, Duration shift) {
  slot.period_average = in.getPeriodAverage();
  slot.period_deviation = in.getPeriodDeviation();
  slot.period_min = in.getPeriodMin();
  slot.period_max = in.getPeriodMax();
  slot.samples = in.getSamples();
  slot.stamp = suture::rpc::shifted(in.getStamp(), shift);
  slot.valid = in.getValid();
  return Errc{};
}

bool isValid(const IntervalStatisticsSlot& slot) {
  return isValid(slot.period_average) && isValid(slot.period_deviation) &&
      isValid(slot.period_min) && isValid(slot.period_max);
}

void toWire(const KeyValueSlot& slot, wire::KeyValue::Builder out) {
  toWire(slot.key, out.initKey(slot.key.size));
  toWire(slot.value, out.initValue(slot.value.size));
}

Errc fromWire(wire::KeyValue::Reader in, KeyValueSlot& slot, Duration) {
  return firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value),
  });
}

bool isValid(const KeyValueSlot&) {
  return true;
}

}  // namespace robots
