#pragma once

#define MAVLINK_MSG_ID_STATUSTEXT 253

MAVPACKED(typedef struct __mavlink_statustext_t {
  uint8_t severity;
  char text[50];
  uint16_t id;
  uint8_t chunk_seq;
})
mavlink_statustext_t;

#define MAVLINK_MSG_ID_STATUSTEXT_LEN 54

static inline void mavlink_msg_statustext_decode(const mavlink_message_t* msg,
                                                 mavlink_statustext_t* statustext) {
  const uint8_t len =
      msg->len < MAVLINK_MSG_ID_STATUSTEXT_LEN ? msg->len : MAVLINK_MSG_ID_STATUSTEXT_LEN;
  memset(statustext, 0, MAVLINK_MSG_ID_STATUSTEXT_LEN);
  memcpy(statustext, msg->payload64, len);
}
