#pragma once

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// In seconds; negative if `to` is the earlier one.
inline double secondsBetween(suture::Time from, suture::Time to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace robots
