#pragma once

#include <chrono>

#include "support/pass.h"

namespace suture {

/// Waits for what another thread will bring about; false after ten seconds. Asks no more once it is
/// so: a condition may have an effect.
template <class Condition>
bool eventually(const Condition& condition) {
  const Time deadline = now() + std::chrono::seconds(10);
  while (!condition()) {
    if (now() >= deadline) return false;
    pass(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace suture
