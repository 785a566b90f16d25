#include <suture/component/event_task.h>

namespace suture {

bool EventTask::awaitCycle() {
  // within() inside a cycle may have taken notice of a ring that announced something else.
  if (!stopping() && !workPending()) doorbell().waitUntil(now() + longestSleep_);
  return !stopping();
}

}  // namespace suture
