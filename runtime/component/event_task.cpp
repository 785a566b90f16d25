#include <suture/component/event_task.h>

namespace suture {

bool EventTask::awaitCycle() {
  const Time latest = now() + longestSleep_;
  while (!stopping() && !workPending()) {
    // What arrived may have been taken in the cycle before, by a wait or a poll.
    if (doorbell().waitUntil(latest) != rt::RungFor::Arrival) break;
  }
  return !stopping();
}

}  // namespace suture
