#pragma once

#include <suture/base/time.h>

#include <chrono>
#include <thread>

namespace suture {

/// Waits for what another thread will bring about; false after ten seconds.
template <class Condition>
bool eventually(const Condition& condition) {
  const Time deadline = now() + std::chrono::seconds(10);
  while (!condition() && now() < deadline) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return condition();
}

}  // namespace suture
