#include "coordinator/coordinator.h"

#include <utility>

namespace robots {

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

// A stop that is released in the cycle in which it was pressed withholds one permit all the same.
void Coordinator::run() {
  permit_ = {!pressed_ && !std::exchange(wasPressed_, false), suture::now()};
}

// Emits the event at once, so that it does not wait for the next permit, and even if nothing
// changes, so that a client that missed one is corrected.
void Coordinator::set(bool pressed) {
  pressed_ = pressed;
  wasPressed_ = wasPressed_ || pressed;
  stop_.emit().stop({pressed, suture::now()});
}

}  // namespace robots
