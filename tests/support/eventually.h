#pragma once

#include "support/pass.h"
#include "support/patience.h"

namespace suture {

/// Waits until another thread has made the condition true; returns false if it has not after
/// kPatience. Does not ask again once it is true, because to ask may have an effect.
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
