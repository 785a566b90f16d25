#pragma once

#define MAVLINK_MSG_ID_ATTITUDE 30

MAVPACKED(typedef struct __mavlink_attitude_t {
  uint32_t time_boot_ms; /*< [ms]*/
  float roll;            /*< [rad]*/
  float pitch;           /*< [rad]*/
  float yaw;             /*< [rad]*/
  float rollspeed;       /*< [rad/s]*/
  float pitchspeed;      /*< [rad/s]*/
  float yawspeed;        /*< [rad/s]*/
})
mavlink_attitude_t;

#define MAVLINK_MSG_ID_ATTITUDE_LEN 28

static inline void mavlink_msg_attitude_decode(const mavlink_message_t* msg,
                                               mavlink_attitude_t* attitude) {
  const uint8_t len =
      msg->len < MAVLINK_MSG_ID_ATTITUDE_LEN ? msg->len : MAVLINK_MSG_ID_ATTITUDE_LEN;
  memset(attitude, 0, MAVLINK_MSG_ID_ATTITUDE_LEN);
  memcpy(attitude, msg->payload64, len);
}
