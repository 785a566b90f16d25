#pragma once
// How a component waits in its own thread for something that will ring.

#include <suture/base/time.h>
#include <suture/component/component.h>

namespace suture {

/// From the thread of `component`, in a cycle or without: sleeps until `over()`, which is asked
/// after each ring, or until `deadline`. A ring that brought something else is handed on to the
/// next cycle.
template <class Over>
void sleepUntil(Component& component, Time deadline, const Over& over) {
  component.ringNow();
  bool rung = false, forOthers = false;
  while (!over()) {
    forOthers = forOthers || rung;
    if (now() >= deadline) break;
    rung = component.doorbell().waitUntil(deadline);
  }
  if (forOthers) component.doorbell().ring();
}

}  // namespace suture
