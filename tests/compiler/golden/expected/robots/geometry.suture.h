// Written by suturec from robots/geometry.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robots/geometry.h"

namespace robots {

/// A pose with its time.
struct PoseStampedSlot {
  std::array<double, 12> pose;  // Eigen::Isometry3d
  std::int64_t stamp;           // suture::Time, ns
  std::uint8_t valid;           // bool
};

inline bool store(const PoseStamped& value, PoseStampedSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.pose, slot.pose);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const PoseStampedSlot& slot, PoseStamped& value) {
  using suture::load;
  load(slot.pose, value.pose);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

}  // namespace robots
