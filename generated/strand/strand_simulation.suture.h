// Written by suturec from strand/strand_simulation.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "strand/strand_simulation.h"
#include "arm/arm.suture.h"
#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct StrandParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double length;        // m
  double friction;
  double wrap;  // rad
};

bool store(const StrandParameters& value, StrandParametersSlot& slot);
void load(const StrandParametersSlot& slot, StrandParameters& value);

bool isValid(const StrandParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, StrandParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandParameters& value);

template <>
ComponentClass componentClass<robots::StrandSimulation>();

}  // namespace suture
