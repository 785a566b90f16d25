// Written by suturec from person/keyboard.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "person/keyboard.h"
#include "arm/arm.suture.h"
#include "drives/gripper_hand.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct KeyboardParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedText<255> terminal;
  double speed;          // m/s
  double turning_speed;  // rad/s
  double opening;        // rad
  std::int64_t hold;     // std::chrono::nanoseconds, ns
};

bool store(const KeyboardParameters& value, KeyboardParametersSlot& slot);
void load(const KeyboardParametersSlot& slot, KeyboardParameters& value);
void reserve(const KeyboardParametersSlot*, KeyboardParameters& value);

bool isValid(const KeyboardParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, KeyboardParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KeyboardParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyboardParameters& value);

template <>
ComponentClass componentClass<robots::Keyboard>();

}  // namespace suture
