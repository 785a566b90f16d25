// Written by suturec from reference/simulated_arm.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "reference/simulated_arm.h"
#include "reference/arm_like.suture.h"

namespace suture {
class JsonReader;
}

namespace reference {

/// Parameters of SimulatedArm.
struct SimulatedArmParametersSlot {
  double period;               // s
  std::array<double, 3> home;  // m
  suture::OpenText model;
};

bool store(const SimulatedArmParameters& value, SimulatedArmParametersSlot& slot);
void load(const SimulatedArmParametersSlot& slot, SimulatedArmParameters& value);

bool isValid(const SimulatedArmParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SimulatedArmParameters& value);

}  // namespace reference

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const reference::SimulatedArmParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, reference::SimulatedArmParameters& value);

template <>
ComponentClass componentClass<reference::SimulatedArm>();

}  // namespace suture
