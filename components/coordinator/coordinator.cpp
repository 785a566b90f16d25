#include "coordinator/coordinator.h"

namespace robots {

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

void Coordinator::run() { permit_ = {!pressed_, suture::now()}; }

// Tells it at once: the event is not to wait for the next permit.
void Coordinator::set(bool pressed) {
  if (pressed_ == pressed) return;
  pressed_ = pressed;
  stop_.emit().stop({pressed, suture::now()});
}

}  // namespace robots
