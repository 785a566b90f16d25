#pragma once
// These are PX4's topics, whose padding is carried or not, as the header says.

#include "labs/px4.h"
#include "members.h"

namespace invented {

auto fields(As<vehicle_attitude_s> auto& v, Tag) {
  return list(v.timestamp, v.timestamp_sample, v.q, v.delta_q_reset, v.quat_reset_counter);
}
auto fields(As<vehicle_status_s> auto& v, Tag) {
  return list(v.timestamp, v.armed_time, v.failure_detector_status, v.arming_state, v.nav_state,
              v.failsafe, v.safety_button_available, v._padding0);
}
auto fields(As<esc_report_s> auto& v, Tag) {
  return list(v.timestamp, v.esc_errorcount, v.esc_rpm, v.esc_voltage, v.esc_current,
              v.esc_temperature, v.esc_address, v.actuator_function, v.esc_power);
}
auto fields(As<esc_status_s> auto& v, Tag) {
  return list(v.timestamp, v.counter, v.esc_count, v.esc_connectiontype, v.esc);
}
auto fields(As<debug_key_value_s> auto& v, Tag) { return list(v.timestamp, v.value, v.key); }

}  // namespace invented
