#pragma once
// These are MAVLink's packed structs. No reference to their members is taken, for few lie where
// they should.

#include "labs/mavlink.h"
#include "members.h"

namespace invented {

static_assert(sizeof(mavlink_attitude_t) == MAVLINK_MSG_ID_ATTITUDE_LEN);
static_assert(sizeof(mavlink_battery_status_t) == MAVLINK_MSG_ID_BATTERY_STATUS_LEN);
static_assert(sizeof(mavlink_odometry_t) == MAVLINK_MSG_ID_ODOMETRY_LEN);

template <class T>
concept Packed = std::is_trivially_copyable_v<T> && alignof(T) == 1 && std::is_class_v<T>;

inline float real(Random& random) {
  float value;
  fillMember(value, random);
  return value;
}
template <class T>
void fillBytes(T& value, Random& random) {
  std::array<unsigned char, sizeof(T)> bytes;
  fillMember(bytes, random);
  std::memcpy(&value, bytes.data(), sizeof value);
}

// Each byte of a packed struct counts: integers may have any, real numbers are drawn.
template <Packed T>
void fill(T& value, Random& random, Bounds&) {
  fillBytes(value, random);
  if constexpr (std::is_same_v<T, mavlink_attitude_t>) {
    value.roll = real(random);
    value.pitch = real(random);
    value.yaw = real(random);
  }
  if constexpr (std::is_same_v<T, mavlink_odometry_t>) {
    value.x = real(random);
    value.y = real(random);
    value.z = real(random);
    value.vx = real(random);
    value.vy = real(random);
    value.vz = real(random);
    for (std::size_t i = 0; i < 4; ++i) value.q[i] = real(random);
    for (std::size_t i = 0; i < 21; ++i) {
      value.pose_covariance[i] = real(random);
      value.velocity_covariance[i] = real(random);
    }
  }
  if constexpr (requires { value.rollspeed; }) {
    value.rollspeed = real(random);
    value.pitchspeed = real(random);
    value.yawspeed = real(random);
  }
}
/// Its number is a bit-field, which is left out.
inline void fill(mavlink_message_t& value, Random& random, Bounds&) {
  fillBytes(value, random);
  value.msgid = 0;
}
template <Packed T>
bool equal(const T& a, const T& b, Tag) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline void fill(mavlink_parse_state_t& value, Random& random, Bounds&) {
  pick(value, random, {MAVLINK_PARSE_STATE_UNINIT, MAVLINK_PARSE_STATE_GOT_LENGTH});
}
auto fields(As<mavlink_status_t> auto& v, Tag) {
  return list(v.msg_received, v.buffer_overrun, v.parse_error, v.parse_state, v.packet_idx,
              v.packet_rx_success_count, v.packet_rx_drop_count);
}

}  // namespace invented
