// Written by suturec from arm_control/mtm.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "arm_control/mtm.h"
#include "arm/arm.suture.h"
#include "arm/gripper.suture.h"
#include "drives/drives.suture.h"
#include "robot_types/side.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct MtmParametersSlot {
  std::uint8_t side;            // Side
  std::int64_t period;          // std::chrono::nanoseconds, ns
  double angular_rate;          // rad/s
  double angular_acceleration;  // rad/s2
  double following_error;       // rad
  double jump_factor;
  double overload_time;     // s
  double servo_horizon;     // s
  double gripper_closed;    // rad
  double gripper_debounce;  // s
};

bool store(const MtmParameters& value, MtmParametersSlot& slot);
void load(const MtmParametersSlot& slot, MtmParameters& value);

bool isValid(const MtmParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, MtmParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::MtmParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::MtmParameters& value);

template <>
ComponentClass componentClass<robots::Mtm>();

}  // namespace suture
