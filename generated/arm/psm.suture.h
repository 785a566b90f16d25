// Written by suturec from arm/psm.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/component_class.h>

#include "arm/psm.h"
#include "arm/arm.suture.h"
#include "arm/crtk_arm.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct PsmParametersSlot {
  std::int64_t period;    // std::chrono::nanoseconds, ns
  double time_constant;   // s
  double angular_rate;    // rad/s
  double insertion_rate;  // m/s
};

inline bool store(const PsmParameters& value, PsmParametersSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.time_constant, slot.time_constant);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.insertion_rate, slot.insertion_rate);
  return fits;
}

inline void load(const PsmParametersSlot& slot, PsmParameters& value) {
  using suture::load;
  load(slot.period, value.period);
  load(slot.time_constant, value.time_constant);
  load(slot.angular_rate, value.angular_rate);
  load(slot.insertion_rate, value.insertion_rate);
}

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, PsmParameters& value);

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Psm>();

}  // namespace suture
