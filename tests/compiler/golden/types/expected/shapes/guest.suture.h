// Written by suturec from shapes/guest.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/component_class.h>

#include "shapes/guest.h"

namespace suture {
class JsonReader;
}

namespace shapes {

struct guestLimitsSlot {
  double low;   // N
  double high;  // N
};

inline bool store(const guest::Limits& value, guestLimitsSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.low, slot.low);
  fits &= store(value.high, slot.high);
  return fits;
}

inline void load(const guestLimitsSlot& slot, guest::Limits& value) {
  using suture::load;
  load(slot.low, value.low);
  load(slot.high, value.high);
}

}  // namespace shapes

namespace guest {

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, Limits& value);

}  // namespace guest

namespace suture {

template <>
ComponentClass componentClass<shapes::Fence>();

}  // namespace suture
