#pragma once

#include "support/pass.h"
#include "support/patience.h"

namespace suture {

/// Waits for what another thread will bring about; false after kPatience. Asks no more once it is
/// so: a condition may have an effect.
template <class Condition>
bool eventually(const Condition& condition) {
  const Time deadline = now() + kPatience;
  while (!condition()) {
    if (now() >= deadline) return false;
    pass(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace suture
