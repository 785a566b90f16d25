#pragma once

#include <uORB/uORB.h>

#ifdef __cplusplus
struct __EXPORT vehicle_attitude_s {
#else
struct vehicle_attitude_s {
#endif
  uint64_t timestamp;
  uint64_t timestamp_sample;
  float q[4];
  float delta_q_reset[4];
  uint8_t quat_reset_counter;
  uint8_t _padding0[7];  // required for logger
#ifdef __cplusplus
  static constexpr uint32_t MESSAGE_VERSION = 0;
#endif
};

#ifdef __cplusplus
namespace px4 {
namespace msg {
using VehicleAttitude = vehicle_attitude_s;
}  // namespace msg
}  // namespace px4
#endif

ORB_DECLARE(vehicle_attitude);
