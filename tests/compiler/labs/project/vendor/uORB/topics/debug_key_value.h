#pragma once

#include <uORB/uORB.h>

#ifdef __cplusplus
struct __EXPORT debug_key_value_s {
#else
struct debug_key_value_s {
#endif
  uint64_t timestamp;
  float value;
  char key[10];
  uint8_t _padding0[2];  // required for logger
#ifdef __cplusplus

#endif
};

#ifdef __cplusplus
namespace px4 {
namespace msg {
using DebugKeyValue = debug_key_value_s;
}  // namespace msg
}  // namespace px4
#endif

ORB_DECLARE(debug_key_value);
