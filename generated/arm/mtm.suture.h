// Written by suturec from arm/mtm.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/component_class.h>

#include "arm/mtm.h"
#include "arm/arm.suture.h"
#include "arm/crtk_arm.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct MtmParametersSlot {
  std::uint8_t side;     // MtmSide
  std::int64_t period;   // std::chrono::nanoseconds, ns
  double time_constant;  // s
  double angular_rate;   // rad/s
};

inline bool store(const MtmParameters& value, MtmParametersSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.side, slot.side);
  fits &= store(value.period, slot.period);
  fits &= store(value.time_constant, slot.time_constant);
  fits &= store(value.angular_rate, slot.angular_rate);
  return fits;
}

inline void load(const MtmParametersSlot& slot, MtmParameters& value) {
  using suture::load;
  load(slot.side, value.side);
  load(slot.period, value.period);
  load(slot.time_constant, value.time_constant);
  load(slot.angular_rate, value.angular_rate);
}

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, MtmParameters& value);

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Mtm>();

}  // namespace suture
