#pragma once

#include <suture/base/virtual_time.h>

#include <thread>

namespace suture {

/// Lets so much time pass: at once on a stepped clock, while everybody else goes on; else as long
/// as it takes.
inline void pass(Duration duration) {
  VirtualTime* const time = virtualTime();
  if (time == nullptr) return std::this_thread::sleep_for(duration);
  time->spend(duration);
}

}  // namespace suture
