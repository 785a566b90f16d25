// Written by suturec from drives/mtm_drives.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "drives/mtm_drives.h"
#include "coordinator/emergency_stop.suture.h"
#include "drives/drive_dynamics.suture.h"
#include "drives/drives.suture.h"
#include "drives/gripper_hand.suture.h"
#include "robot_types/side.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct MtmDrivesParametersSlot {
  std::uint8_t side;      // Side
  std::int64_t period;    // std::chrono::nanoseconds, ns
  double time_constant;   // s
  double angular_rate;    // rad/s
  std::int64_t permit;    // std::chrono::nanoseconds, ns
  std::uint8_t dynamics;  // DriveDynamics
  RigidBodyOptionsSlot rigid_body;
};

bool store(const MtmDrivesParameters& value, MtmDrivesParametersSlot& slot);
void load(const MtmDrivesParametersSlot& slot, MtmDrivesParameters& value);

bool isValid(const MtmDrivesParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, MtmDrivesParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::MtmDrivesParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::MtmDrivesParameters& value);

template <>
ComponentClass componentClass<robots::MtmDrives>();

}  // namespace suture
