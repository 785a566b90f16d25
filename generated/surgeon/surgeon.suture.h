// Written by suturec from surgeon/surgeon.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/component_class.h>

#include "surgeon/surgeon.h"
#include "arm/arm.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct SurgeonParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double amplitude;     // m
  double turn;          // rad
  double frequency;     // Hz
  double ramp;          // s
};

inline bool store(const SurgeonParameters& value, SurgeonParametersSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.amplitude, slot.amplitude);
  fits &= store(value.turn, slot.turn);
  fits &= store(value.frequency, slot.frequency);
  fits &= store(value.ramp, slot.ramp);
  return fits;
}

inline void load(const SurgeonParametersSlot& slot, SurgeonParameters& value) {
  using suture::load;
  load(slot.period, value.period);
  load(slot.amplitude, value.amplitude);
  load(slot.turn, value.turn);
  load(slot.frequency, value.frequency);
  load(slot.ramp, value.ramp);
}

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SurgeonParameters& value);

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Surgeon>();

}  // namespace suture
