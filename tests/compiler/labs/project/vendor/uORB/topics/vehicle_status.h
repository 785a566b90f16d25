#pragma once

#include <uORB/uORB.h>

#ifdef __cplusplus
struct __EXPORT vehicle_status_s {
#else
struct vehicle_status_s {
#endif
  uint64_t timestamp;
  uint64_t armed_time;
  uint16_t failure_detector_status;
  uint8_t arming_state;
  uint8_t nav_state;
  bool failsafe;
  bool safety_button_available;
  uint8_t _padding0[2];  // required for logger
#ifdef __cplusplus
  static constexpr uint8_t ARMING_STATE_DISARMED = 1;
  static constexpr uint8_t ARMING_STATE_ARMED = 2;
  static constexpr uint8_t NAVIGATION_STATE_MANUAL = 0;
  static constexpr uint8_t NAVIGATION_STATE_MAX = 31;
#endif
};

#ifdef __cplusplus
namespace px4 {
namespace msg {
using VehicleStatus = vehicle_status_s;
}  // namespace msg
}  // namespace px4
#endif

ORB_DECLARE(vehicle_status);
