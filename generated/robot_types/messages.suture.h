// Written by suturec from robot_types/messages.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/messages.h"

namespace robots {

/// CRTK's status, warning and error.
struct MessageSlot {
  suture::BoundedText<127> text;
  std::uint32_t counter;
  std::int64_t stamp;  // suture::Time, ns
};

inline bool store(const Message& value, MessageSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.text, slot.text);
  fits &= store(value.counter, slot.counter);
  fits &= store(value.stamp, slot.stamp);
  return fits;
}

inline void load(const MessageSlot& slot, Message& value) {
  using suture::load;
  load(slot.text, value.text);
  load(slot.counter, value.counter);
  load(slot.stamp, value.stamp);
}

/// How regularly a task ran, over its last window.
struct IntervalStatisticsSlot {
  double period_average;    // s
  double period_deviation;  // s
  double period_min;        // s
  double period_max;        // s
  std::uint32_t samples;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const IntervalStatistics& value, IntervalStatisticsSlot& slot) {
  using suture::store;
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

inline void load(const IntervalStatisticsSlot& slot, IntervalStatistics& value) {
  using suture::load;
  load(slot.period_average, value.period_average);
  load(slot.period_deviation, value.period_deviation);
  load(slot.period_min, value.period_min);
  load(slot.period_max, value.period_max);
  load(slot.samples, value.samples);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmKeyValue.
struct KeyValueSlot {
  suture::BoundedText<31> key;
  suture::BoundedText<127> value;
};

inline bool store(const KeyValue& value, KeyValueSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.key, slot.key);
  fits &= store(value.value, slot.value);
  return fits;
}

inline void load(const KeyValueSlot& slot, KeyValue& value) {
  using suture::load;
  load(slot.key, value.key);
  load(slot.value, value.value);
}

}  // namespace robots
