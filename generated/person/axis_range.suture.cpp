// Written by suturec from person/axis_range.h. Do not edit.
#include "person/axis_range.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(AxisRange::lowest), std::int32_t>);
static_assert(std::is_same_v<decltype(AxisRange::highest), std::int32_t>);

}  // namespace

bool store(const AxisRange& value, AxisRangeSlot& slot) {
  bool fits = true;
  fits &= store(value.lowest, slot.lowest);
  fits &= store(value.highest, slot.highest);
  return fits;
}

void load(const AxisRangeSlot& slot, AxisRange& value) {
  load(slot.lowest, value.lowest);
  load(slot.highest, value.highest);
}

bool isValid(const AxisRangeSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, AxisRange& value) {
  suture::JsonReader reader = in;
  reader.field("lowest", value.lowest);
  reader.field("highest", value.highest);
  reader.finish();
}

}  // namespace robots
