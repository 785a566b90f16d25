#pragma once

#include <suture/base/virtual_time.h>

#include <chrono>
#include <thread>

namespace suture {

/// Lets time pass for as long as a test waits between two looks at the same thing.
inline void pauseBetweenLooks() {
  constexpr auto kPause = std::chrono::microseconds(200);
  VirtualTime* const time = virtualTime();
  if (time == nullptr) return std::this_thread::sleep_for(kPause);
  time->spend(kPause);
}

/// Waits for what another thread will bring about; false after ten seconds. Asks no more once it is
/// so: a condition may have an effect.
template <class Condition>
bool eventually(const Condition& condition) {
  const Time deadline = now() + std::chrono::seconds(10);
  while (!condition()) {
    if (now() >= deadline) return false;
    pauseBetweenLooks();
  }
  return true;
}

}  // namespace suture
