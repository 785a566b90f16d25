#pragma once

#include <chrono>

#include "support/pass.h"

namespace suture {

/// Waits for what another thread will bring about; false after a minute, which is many times what
/// anything takes on a busy machine. Asks no more once it is so: a condition may have an effect.
template <class Condition>
bool eventually(const Condition& condition) {
  const Time deadline = now() + std::chrono::minutes(1);
  while (!condition()) {
    if (now() >= deadline) return false;
    pass(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace suture
