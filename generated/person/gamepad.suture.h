// Written by suturec from person/gamepad.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "person/gamepad.h"
#include "arm/arm.suture.h"
#include "drives/gripper_hand.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "person/axis_range.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct GamepadParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedText<255> file;
  AxisRangeSlot stick;
  AxisRangeSlot trigger;
  double dead_zone;
  double speed;          // m/s
  double turning_speed;  // rad/s
  double opening;        // rad
  std::int64_t retry;    // std::chrono::nanoseconds, ns
};

bool store(const GamepadParameters& value, GamepadParametersSlot& slot);
void load(const GamepadParametersSlot& slot, GamepadParameters& value);
void reserve(const GamepadParametersSlot*, GamepadParameters& value);

bool isValid(const GamepadParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, GamepadParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GamepadParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::GamepadParameters& value);

template <>
ComponentClass componentClass<robots::Gamepad>();

}  // namespace suture
