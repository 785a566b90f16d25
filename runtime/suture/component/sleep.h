#pragma once
// How a component waits in its own thread for something that will ring.

#include <suture/base/time.h>
#include <suture/component/component.h>

namespace suture {

/// From the thread of `component`, in a cycle or without: sleeps until `over()`, which is asked
/// after each ring, or until `deadline`. Work that was rung for is handed on to the next cycle.
template <class Over>
void sleepUntil(Component& component, Time deadline, const Over& over) {
  component.ringNow();
  struct HandOn {  // also when over() throws
    ~HandOn() {
      if (work) bell.ring();
    }
    rt::Doorbell& bell;
    bool work = false;
  } rung{component.doorbell()};
  while (!over() && now() < deadline) {
    if (rung.bell.waitUntil(deadline) == rt::RungFor::Work) rung.work = true;
  }
}

}  // namespace suture
