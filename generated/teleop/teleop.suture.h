// Written by suturec from teleop/teleop.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "teleop/teleop.h"
#include "arm/arm.suture.h"
#include "arm/gripper.suture.h"
#include "arm/jaw.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"
#include "registration/registration.suture.h"
#include "robot_types/side.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct TeleopParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double scale;
  std::int64_t max_age;            // std::chrono::nanoseconds, ns
  std::uint8_t enable_at_start;    // bool
  std::uint8_t align;              // bool
  double alignment_tolerance;      // rad
  std::uint8_t release_master;     // bool
  std::int64_t preparation_limit;  // std::chrono::nanoseconds, ns
  std::int64_t operator_age;       // std::chrono::nanoseconds, ns
  std::int64_t registration_age;   // std::chrono::nanoseconds, ns
  double jaw_scale;
  double jaw_offset;         // rad
  double jaw_rate;           // rad/s
  double jaw_ghost_rate;     // rad/s
  double jaw_tolerance;      // rad
  std::uint8_t master_side;  // Side
  std::uint8_t slave_side;   // Side
};

bool store(const TeleopParameters& value, TeleopParametersSlot& slot);
void load(const TeleopParametersSlot& slot, TeleopParameters& value);

bool isValid(const TeleopParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, TeleopParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::TeleopParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::TeleopParameters& value);

template <>
ComponentClass componentClass<robots::Teleop>();

}  // namespace suture
