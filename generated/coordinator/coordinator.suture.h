// Written by suturec from coordinator/coordinator.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "coordinator/coordinator.h"
#include "coordinator/emergency_stop.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct CoordinatorParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedList<suture::BoundedText<63>, 8> buttons;
};

bool store(const CoordinatorParameters& value, CoordinatorParametersSlot& slot);
void load(const CoordinatorParametersSlot& slot, CoordinatorParameters& value);
void reserve(const CoordinatorParametersSlot*, CoordinatorParameters& value);

bool isValid(const CoordinatorParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, CoordinatorParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::CoordinatorParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::CoordinatorParameters& value);

template <>
ComponentClass componentClass<robots::Coordinator>();

}  // namespace suture
