// Written by suturec from drives/psm_drives.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "drives/psm_drives.h"
#include "coordinator/emergency_stop.suture.h"
#include "drives/drive_dynamics.suture.h"
#include "drives/drives.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct PsmDrivesParametersSlot {
  std::int64_t period;    // std::chrono::nanoseconds, ns
  double time_constant;   // s
  double angular_rate;    // rad/s
  double insertion_rate;  // m/s
  double jaw_rate;        // rad/s
  std::int64_t permit;    // std::chrono::nanoseconds, ns
  std::uint8_t dynamics;  // DriveDynamics
  RigidBodyOptionsSlot rigid_body;
};

bool store(const PsmDrivesParameters& value, PsmDrivesParametersSlot& slot);
void load(const PsmDrivesParametersSlot& slot, PsmDrivesParameters& value);

bool isValid(const PsmDrivesParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, PsmDrivesParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PsmDrivesParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PsmDrivesParameters& value);

template <>
ComponentClass componentClass<robots::PsmDrives>();

}  // namespace suture
