#pragma once

#include <uORB/uORB.h>

#ifdef __cplusplus
struct __EXPORT esc_report_s {
#else
struct esc_report_s {
#endif
  uint64_t timestamp;
  uint32_t esc_errorcount;
  int32_t esc_rpm;
  float esc_voltage;
  float esc_current;
  float esc_temperature;
  uint8_t esc_address;
  uint8_t actuator_function;
  int8_t esc_power;
  uint8_t _padding0[1];  // required for logger
#ifdef __cplusplus
  static constexpr uint8_t ACTUATOR_FUNCTION_MOTOR1 = 101;
  static constexpr uint8_t FAILURE_NONE = 0;
#endif
};

#ifdef __cplusplus
namespace px4 {
namespace msg {
using EscReport = esc_report_s;
}  // namespace msg
}  // namespace px4
#endif

ORB_DECLARE(esc_report);
