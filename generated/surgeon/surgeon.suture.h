// Written by suturec from surgeon/surgeon.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "surgeon/surgeon.h"
#include "arm/arm.suture.h"
#include "drives/gripper_hand.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct SurgeonParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double amplitude;     // m
  double turn;          // rad
  double frequency;     // Hz
  double opening;       // rad
  double ramp;          // s
};

bool store(const SurgeonParameters& value, SurgeonParametersSlot& slot);
void load(const SurgeonParametersSlot& slot, SurgeonParameters& value);

bool isValid(const SurgeonParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SurgeonParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SurgeonParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::SurgeonParameters& value);

template <>
ComponentClass componentClass<robots::Surgeon>();

}  // namespace suture
