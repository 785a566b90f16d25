// Written by suturec from shapes/guest.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "shapes/guest.h"

namespace suture {
class JsonReader;
}

namespace shapes {

struct guestLimitsSlot {
  double low;   // N
  double high;  // N
};

bool store(const guest::Limits& value, guestLimitsSlot& slot);
void load(const guestLimitsSlot& slot, guest::Limits& value);

bool isValid(const guestLimitsSlot& slot, suture::FieldPath* path);

}  // namespace shapes

namespace guest {

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, Limits& value);

}  // namespace guest

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const guest::Limits& value);
template <>
Result<> decode(std::span<const std::byte> bytes, guest::Limits& value);

template <>
ComponentClass componentClass<shapes::Fence>();

}  // namespace suture
