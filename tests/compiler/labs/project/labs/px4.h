#pragma once
// These are topics of PX4: plain structs with constants, and bytes that only its logger wants.

#include <suture/annotate.h>

#include <uORB/topics/debug_key_value.h>
#include <uORB/topics/esc_status.h>
#include <uORB/topics/vehicle_attitude.h>
#include <uORB/topics/vehicle_status.h>

SUTURE_EXTERNAL_TYPE(vehicle_attitude_s, all(), member(_padding0, skip()));
SUTURE_EXTERNAL_TYPE(px4::msg::VehicleStatus);
SUTURE_EXTERNAL_TYPE(esc_report_s, name("Esc"), all(), member(esc_voltage, unit("V")),
                     member(_padding0, skip()));
SUTURE_EXTERNAL_TYPE(esc_status_s, timestamp, counter, esc_count, esc_connectiontype, esc);
SUTURE_EXTERNAL_TYPE(debug_key_value_s, all(), member(_padding0, skip()));

namespace lab {

/// A vehicle of PX4.
class SUTURE_INTERFACE() Vehicle {
 public:
  virtual ~Vehicle() = default;
  SUTURE_COMMAND(latest()) virtual void turn(const vehicle_attitude_s& goal) = 0;
  SUTURE_COMMAND() virtual const px4::msg::VehicleStatus& status() const = 0;
  SUTURE_COMMAND() virtual const px4::msg::VehicleAttitude& attitude() const = 0;
  SUTURE_COMMAND() virtual const esc_status_s& escs() const = 0;
  SUTURE_EVENT() suture::EventOf<px4::msg::DebugKeyValue> debugged;
};

}  // namespace lab
