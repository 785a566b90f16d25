// Written by suturec from shapes/guest.h. Do not edit.
#include "shapes/guest.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(guest::Limits::low), double>);
static_assert(std::is_same_v<decltype(guest::Limits::high), double>);

}  // namespace

bool store(const guest::Limits& value, guestLimitsSlot& slot) {
  bool fits = true;
  fits &= store(value.low, slot.low);
  fits &= store(value.high, slot.high);
  return fits;
}

void load(const guestLimitsSlot& slot, guest::Limits& value) {
  load(slot.low, value.low);
  load(slot.high, value.high);
}

bool isValid(const guestLimitsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.low)) return suture::refusedAt(path, "low");
  return isValid(slot.high) || suture::refusedAt(path, "high");
}

}  // namespace shapes

namespace guest {

void fromJson(const suture::JsonReader& in, Limits& value) {
  suture::JsonReader reader = in;
  reader.field("low", value.low);
  reader.field("high", value.high);
  reader.finish();
}

}  // namespace guest

namespace suture {

template <>
ComponentClass componentClass<shapes::Fence>() {
  return {"Fence", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            guest::Limits values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new shapes::Fence(values));
          }};
}

}  // namespace suture
