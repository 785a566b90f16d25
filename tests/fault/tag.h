#pragma once
// These poses say what they are, so that each damage to one is seen.

#include <cmath>
#include <cstdint>
#include <cstring>

#include "reference/arm_types.h"

namespace reference {

/// A command has a client, a number and a connection; an event has a provider and a number.
struct Tag {
  std::uint32_t who = 0;
  std::uint64_t number = 0, epoch = 0;
};

inline PoseStamped poseOf(const Tag& tag) {
  PoseStamped pose;
  pose.pose.setIdentity();
  pose.pose.translation() << tag.who, static_cast<double>(tag.number),
      static_cast<double>(tag.epoch);
  pose.valid = true;
  return pose;
}

/// Returns a tag that no pose has if one bit of the numbers in the pose is wrong.
inline Tag tagIn(const PoseStamped& pose) {
  const auto& numbers = pose.pose.translation();
  for (int i = 0; i < 3; ++i) {
    if (!(numbers[i] >= 0 && numbers[i] < std::ldexp(1.0, 32))) return {};
  }
  const Tag tag{static_cast<std::uint32_t>(numbers.x()), static_cast<std::uint64_t>(numbers.y()),
                static_cast<std::uint64_t>(numbers.z())};
  const PoseStamped whole = poseOf(tag);
  const auto& bits = pose.pose.matrix();
  const bool damaged =
      std::memcmp(bits.data(), whole.pose.matrix().data(), bits.size() * sizeof(double)) != 0;
  return damaged || !pose.valid ? Tag{} : tag;
}

}  // namespace reference
