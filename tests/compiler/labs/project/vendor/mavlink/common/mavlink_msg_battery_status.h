#pragma once

#define MAVLINK_MSG_ID_BATTERY_STATUS 147

MAVPACKED(typedef struct __mavlink_battery_status_t {
  int32_t current_consumed; /*< [mAh]*/
  int32_t energy_consumed;  /*< [hJ]*/
  int16_t temperature;      /*< [cdegC]*/
  uint16_t voltages[10];    /*< [mV]*/
  int16_t current_battery;  /*< [cA]*/
  uint8_t id;
  uint8_t battery_function;
  uint8_t type;
  int8_t battery_remaining; /*< [%]*/
  int32_t time_remaining;   /*< [s]*/
  uint8_t charge_state;
  uint16_t voltages_ext[4]; /*< [mV]*/
  uint8_t mode;
  uint32_t fault_bitmask;
})
mavlink_battery_status_t;

#define MAVLINK_MSG_ID_BATTERY_STATUS_LEN 54

static inline void mavlink_msg_battery_status_decode(const mavlink_message_t* msg,
                                                     mavlink_battery_status_t* battery_status) {
  const uint8_t len =
      msg->len < MAVLINK_MSG_ID_BATTERY_STATUS_LEN ? msg->len : MAVLINK_MSG_ID_BATTERY_STATUS_LEN;
  memset(battery_status, 0, MAVLINK_MSG_ID_BATTERY_STATUS_LEN);
  memcpy(battery_status, msg->payload64, len);
}
