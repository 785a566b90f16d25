// This has the shape of libfranka's franka/vacuum_gripper_state.h.
#pragma once

#include <cstdint>

#include <franka/duration.h>

namespace franka {

enum class VacuumGripperDeviceStatus : uint8_t { kGreen, kYellow, kOrange, kRed };

struct VacuumGripperState {
  bool in_control_range{};
  bool part_detached{};
  bool part_present{};
  VacuumGripperDeviceStatus device_status{};
  uint16_t actual_power{};
  uint16_t vacuum{};
  Duration time{};
};

}  // namespace franka
