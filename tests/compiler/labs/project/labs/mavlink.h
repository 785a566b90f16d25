#pragma once
// These are messages of MAVLink: packed structs and enums of C, none of which lies in a namespace.

#include <suture/annotate.h>

#include <mavlink/common/common.h>

namespace lab {

SUTURE_EXTERNAL_TYPE(MAV_MODE_FLAG);
SUTURE_EXTERNAL_TYPE(MAV_SEVERITY);
SUTURE_EXTERNAL_TYPE(mavlink_parse_state_t);
SUTURE_EXTERNAL_TYPE(mavlink_system_t);
SUTURE_EXTERNAL_TYPE(mavlink_status_t, all(), member(signing, skip()));
SUTURE_EXTERNAL_TYPE(mavlink_heartbeat_t);
SUTURE_EXTERNAL_TYPE(mavlink_attitude_t, all(), member(roll, unit("rad")),
                     member(rollspeed, unit("rad/s")));
SUTURE_EXTERNAL_TYPE(mavlink_battery_status_t);
SUTURE_EXTERNAL_TYPE(mavlink_odometry_t);
SUTURE_EXTERNAL_TYPE(mavlink_statustext_t);
SUTURE_EXTERNAL_TYPE(mavlink_message_t, all(), member(msgid, skip()), member(payload64, bulk()));

/// A flight controller.
class SUTURE_INTERFACE() Autopilot {
 public:
  virtual ~Autopilot() = default;
  SUTURE_COMMAND(latest()) virtual void attitude(const mavlink_attitude_t& attitude) = 0;
  SUTURE_COMMAND() virtual void setMode(MAV_MODE_FLAG mode) = 0;
  SUTURE_COMMAND() virtual const mavlink_odometry_t& odometry() const = 0;
  SUTURE_COMMAND() virtual const mavlink_battery_status_t& battery() const = 0;
  SUTURE_COMMAND() virtual const mavlink_status_t& status() const = 0;
  SUTURE_EVENT(queue(8)) suture::EventOf<mavlink_system_t, mavlink_heartbeat_t> heartbeat;
  SUTURE_EVENT(queue(8)) suture::EventOf<mavlink_statustext_t, MAV_SEVERITY> text;
};

}  // namespace lab
