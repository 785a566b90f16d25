#pragma once

#define MAVLINK_MSG_ID_ODOMETRY 331

MAVPACKED(typedef struct __mavlink_odometry_t {
  uint64_t time_usec; /*< [us]*/
  float x;            /*< [m]*/
  float y;            /*< [m]*/
  float z;            /*< [m]*/
  float q[4];
  float vx;         /*< [m/s]*/
  float vy;         /*< [m/s]*/
  float vz;         /*< [m/s]*/
  float rollspeed;  /*< [rad/s]*/
  float pitchspeed; /*< [rad/s]*/
  float yawspeed;   /*< [rad/s]*/
  float pose_covariance[21];
  float velocity_covariance[21];
  uint8_t frame_id;
  uint8_t child_frame_id;
  uint8_t reset_counter;
  uint8_t estimator_type;
  int8_t quality; /*< [%]*/
})
mavlink_odometry_t;

#define MAVLINK_MSG_ID_ODOMETRY_LEN 233

static inline void mavlink_msg_odometry_decode(const mavlink_message_t* msg,
                                               mavlink_odometry_t* odometry) {
  const uint8_t len =
      msg->len < MAVLINK_MSG_ID_ODOMETRY_LEN ? msg->len : MAVLINK_MSG_ID_ODOMETRY_LEN;
  memset(odometry, 0, MAVLINK_MSG_ID_ODOMETRY_LEN);
  memcpy(odometry, msg->payload64, len);
}
