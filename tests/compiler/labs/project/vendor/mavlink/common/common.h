/* The shape of MAVLink's common/common.h. */
#pragma once

#include "../mavlink_types.h"

#ifndef HAVE_ENUM_MAV_MODE_FLAG
#define HAVE_ENUM_MAV_MODE_FLAG
typedef enum MAV_MODE_FLAG {
  MAV_MODE_FLAG_CUSTOM_MODE_ENABLED = 1,
  MAV_MODE_FLAG_TEST_ENABLED = 2,
  MAV_MODE_FLAG_AUTO_ENABLED = 4,
  MAV_MODE_FLAG_GUIDED_ENABLED = 8,
  MAV_MODE_FLAG_STABILIZE_ENABLED = 16,
  MAV_MODE_FLAG_HIL_ENABLED = 32,
  MAV_MODE_FLAG_MANUAL_INPUT_ENABLED = 64,
  MAV_MODE_FLAG_SAFETY_ARMED = 128,
  MAV_MODE_FLAG_ENUM_END = 129,
} MAV_MODE_FLAG;
#endif

#ifndef HAVE_ENUM_MAV_SEVERITY
#define HAVE_ENUM_MAV_SEVERITY
typedef enum MAV_SEVERITY {
  MAV_SEVERITY_EMERGENCY = 0,
  MAV_SEVERITY_ALERT = 1,
  MAV_SEVERITY_ERROR = 3,
  MAV_SEVERITY_DEBUG = 7,
  MAV_SEVERITY_ENUM_END = 8,
} MAV_SEVERITY;
#endif

#include "./mavlink_msg_attitude.h"
#include "./mavlink_msg_battery_status.h"
#include "./mavlink_msg_heartbeat.h"
#include "./mavlink_msg_odometry.h"
#include "./mavlink_msg_statustext.h"
