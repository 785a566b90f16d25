#include "coordinator/coordinator.h"

#include <chrono>
#include <utility>

namespace robots {
namespace {

// A client whose connection is silent for the usual 2 s loses it, and with it what it has commanded
// meanwhile. It counts from its last heartbeat, which is up to 0.4 s older than the pause.
constexpr suture::Duration kCommandsMayBeLost = std::chrono::milliseconds(1500);

}  // namespace

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

// A stop that is released in the cycle in which it was pressed withholds one permit all the same.
void Coordinator::run() {
  if (cycles_.missed(kCommandsMayBeLost)) set(true);
  permit_ = {!pressed_ && !std::exchange(wasPressed_, false), suture::now()};
}

// The stop begins pressed, because nobody could press it until now.
void Coordinator::begin(bool isStart) {
  cycles_.begin();
  set(true, isStart);
}

// Emits the event at once, so that it does not wait for the next permit, and even if nothing
// changes, so that a client that missed one is corrected.
void Coordinator::set(bool pressed, bool isStart) {
  pressed_ = pressed;
  wasPressed_ = wasPressed_ || pressed;
  stop_.emit().stop({pressed, suture::now(), isStart});
}

}  // namespace robots
