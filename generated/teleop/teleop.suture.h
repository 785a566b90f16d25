// Written by suturec from teleop/teleop.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/component_class.h>

#include "teleop/teleop.h"
#include "arm/arm.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct TeleopParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double scale;
  std::int64_t max_age;          // std::chrono::nanoseconds, ns
  std::uint8_t enable_at_start;  // bool
};

inline bool store(const TeleopParameters& value, TeleopParametersSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.max_age, slot.max_age);
  fits &= store(value.enable_at_start, slot.enable_at_start);
  return fits;
}

inline void load(const TeleopParametersSlot& slot, TeleopParameters& value) {
  using suture::load;
  load(slot.period, value.period);
  load(slot.scale, value.scale);
  load(slot.max_age, value.max_age);
  load(slot.enable_at_start, value.enable_at_start);
}

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, TeleopParameters& value);

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Teleop>();

}  // namespace suture
