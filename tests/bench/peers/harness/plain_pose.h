#pragma once
// Peers that carry memory as it is take the pose as a plain struct.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "harness/pose.h"

namespace peers {

struct PlainPose {
  std::array<double, 9> rotation;
  std::array<double, 3> position;
  double timestamp;
  char frame[8];
  char reference[7];
  std::uint8_t valid;
};
static_assert(sizeof(PlainPose) == 120);

template <std::size_t Size>
void storeText(const std::string& text, char (&room)[Size]) {
  const std::size_t length = std::min(text.size(), Size - 1);
  std::memcpy(room, text.data(), length);
  room[length] = 0;
}

inline void store(const Pose& pose, PlainPose& plain) {
  plain.rotation = pose.rotation;
  plain.position = pose.position;
  plain.timestamp = pose.timestamp;
  plain.valid = pose.valid ? 1 : 0;
  storeText(pose.frame, plain.frame);
  storeText(pose.reference, plain.reference);
}

inline void load(const PlainPose& plain, Pose& pose) {
  pose.rotation = plain.rotation;
  pose.position = plain.position;
  pose.timestamp = plain.timestamp;
  pose.valid = plain.valid != 0;
  pose.frame.assign(plain.frame);
  pose.reference.assign(plain.reference);
}

}  // namespace peers
