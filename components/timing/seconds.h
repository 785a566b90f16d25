#pragma once

#include <suture/base/time.h>

#include <chrono>

namespace robots {

inline double inSeconds(suture::Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Returns the time in seconds; negative if `to` is the earlier one.
inline double secondsBetween(suture::Time from, suture::Time to) { return inSeconds(to - from); }

}  // namespace robots
