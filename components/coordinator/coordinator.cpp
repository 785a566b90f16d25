#include "coordinator/coordinator.h"

#include <utility>

namespace robots {

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

// A stop that is released in the cycle that it was pressed in withholds one permit all the same.
void Coordinator::run() {
  permit_ = {!pressed_ && !std::exchange(wasPressed_, false), suture::now()};
}

// Tells it at once, also what is so already: the event is not to wait for the next permit, and
// whoever missed one is put right.
void Coordinator::set(bool pressed) {
  pressed_ = pressed;
  wasPressed_ = wasPressed_ || pressed;
  stop_.emit().stop({pressed, suture::now()});
}

}  // namespace robots
