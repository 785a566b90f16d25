#pragma once
// How a component waits in its own thread for something that will ring.

#include <suture/base/time.h>
#include <suture/component/component.h>

namespace suture {

/// From the thread of `component`, in a cycle or without: sleeps until `over()`, which is asked
/// after each ring, or until `deadline`. Hands on to the next cycle what was rung for other than
/// arrivals, which can be seen where they arrive.
template <class Over>
void sleepUntil(Component& component, Time deadline, const Over& over) {
  component.ringNow();
  bool work = false;
  while (!over() && now() < deadline) {
    work = component.doorbell().waitUntil(deadline) == rt::Ring::Work || work;
  }
  if (work) component.doorbell().ring();
}

}  // namespace suture
