#pragma once
// This has the shape of PX4's uORB/uORB.h: what describes a topic, and refers to it.

#include <px4_platform_common/defines.h>
#include <stdbool.h>
#include <stdint.h>

struct orb_metadata {
  const char* o_name;
  const uint16_t o_size;
  const uint16_t o_size_no_padding;
  uint8_t o_id;
};

#define ORB_DECLARE(_name) extern "C" const struct orb_metadata __orb_##_name __EXPORT
