#pragma once

#define MAVLINK_MSG_ID_HEARTBEAT 0

MAVPACKED(typedef struct __mavlink_heartbeat_t {
  uint32_t custom_mode;
  uint8_t type;
  uint8_t autopilot;
  uint8_t base_mode;
  uint8_t system_status;
  uint8_t mavlink_version;
})
mavlink_heartbeat_t;

#define MAVLINK_MSG_ID_HEARTBEAT_LEN 9

static inline void mavlink_msg_heartbeat_decode(const mavlink_message_t* msg,
                                                mavlink_heartbeat_t* heartbeat) {
  const uint8_t len =
      msg->len < MAVLINK_MSG_ID_HEARTBEAT_LEN ? msg->len : MAVLINK_MSG_ID_HEARTBEAT_LEN;
  memset(heartbeat, 0, MAVLINK_MSG_ID_HEARTBEAT_LEN);
  memcpy(heartbeat, msg->payload64, len);
}
