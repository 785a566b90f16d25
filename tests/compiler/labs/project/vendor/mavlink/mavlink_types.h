/* The shape of MAVLink's mavlink_types.h, which is C. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#ifdef __GNUC__
#define MAVPACKED(__Declaration__) __Declaration__ __attribute__((packed))
#else
#define MAVPACKED(__Declaration__) __pragma(pack(push, 1)) __Declaration__ __pragma(pack(pop))
#endif

#define MAVLINK_MAX_PAYLOAD_LEN 255
#define MAVLINK_NUM_CHECKSUM_BYTES 2
#define MAVLINK_SIGNATURE_BLOCK_LEN 13

MAVPACKED(typedef struct __mavlink_system {
  uint8_t sysid;
  uint8_t compid;
})
mavlink_system_t;

MAVPACKED(typedef struct __mavlink_message {
  uint16_t checksum;
  uint8_t magic;
  uint8_t len;
  uint8_t incompat_flags;
  uint8_t compat_flags;
  uint8_t seq;
  uint8_t sysid;
  uint8_t compid;
  uint32_t msgid : 24;
  uint64_t payload64[(MAVLINK_MAX_PAYLOAD_LEN + MAVLINK_NUM_CHECKSUM_BYTES + 7) / 8];
  uint8_t ck[2];
  uint8_t signature[MAVLINK_SIGNATURE_BLOCK_LEN];
})
mavlink_message_t;

typedef enum {
  MAVLINK_PARSE_STATE_UNINIT = 0,
  MAVLINK_PARSE_STATE_IDLE,
  MAVLINK_PARSE_STATE_GOT_STX,
  MAVLINK_PARSE_STATE_GOT_LENGTH
} mavlink_parse_state_t;

typedef struct __mavlink_status {
  uint8_t msg_received;
  uint8_t buffer_overrun;
  uint8_t parse_error;
  mavlink_parse_state_t parse_state;
  uint8_t packet_idx;
  uint16_t packet_rx_success_count;
  uint16_t packet_rx_drop_count;
  struct __mavlink_signing* signing;
} mavlink_status_t;
