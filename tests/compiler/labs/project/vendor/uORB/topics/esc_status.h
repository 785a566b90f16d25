#pragma once

#include <uORB/topics/esc_report.h>
#include <uORB/uORB.h>
#ifdef __cplusplus
struct __EXPORT esc_status_s {
#else
struct esc_status_s {
#endif
  uint64_t timestamp;
  uint16_t counter;
  uint8_t esc_count;
  uint8_t esc_connectiontype;
  uint8_t _padding0[4];  // required for logger
  struct esc_report_s esc[8];
#ifdef __cplusplus
  static constexpr uint8_t CONNECTED_ESC_MAX = 8;
  static constexpr uint8_t ESC_CONNECTION_TYPE_CAN = 5;
#endif
};

#ifdef __cplusplus
namespace px4 {
namespace msg {
using EscStatus = esc_status_s;
}  // namespace msg
}  // namespace px4
#endif

ORB_DECLARE(esc_status);
