// Written by suturec from robots/simulated_arm.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "robots/simulated_arm.h"
#include "robots/arm.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

/// How a simulated arm behaves.
struct ArmParametersSlot {
  double rate;  // Hz
  suture::OpenText name;
  std::int8_t start;  // Mode
};

bool store(const ArmParameters& value, ArmParametersSlot& slot);
void load(const ArmParametersSlot& slot, ArmParameters& value);

bool isValid(const ArmParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, ArmParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ArmParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ArmParameters& value);

template <>
ComponentClass componentClass<robots::SimulatedArm>();

}  // namespace suture
