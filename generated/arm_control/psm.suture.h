// Written by suturec from arm_control/psm.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "arm_control/psm.h"
#include "arm/arm.suture.h"
#include "arm/jaw.suture.h"
#include "drives/drives.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct PsmParametersSlot {
  std::int64_t period;               // std::chrono::nanoseconds, ns
  double angular_rate;               // rad/s
  double home_insertion;             // m
  double following_error;            // rad
  double insertion_rate;             // m/s
  double insertion_following_error;  // m
  double angular_acceleration;       // rad/s2
  double insertion_acceleration;     // m/s2
  double jaw_acceleration;           // rad/s2
  double jaw_rate;                   // rad/s
  double jump_factor;
  double overload_time;  // s
  double servo_horizon;  // s
};

bool store(const PsmParameters& value, PsmParametersSlot& slot);
void load(const PsmParametersSlot& slot, PsmParameters& value);

bool isValid(const PsmParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, PsmParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PsmParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PsmParameters& value);

template <>
ComponentClass componentClass<robots::Psm>();

}  // namespace suture
