#pragma once
// This is how a component waits in its own thread for something that will ring.

#include <suture/base/time.h>
#include <suture/component/component.h>

namespace suture {

/// The thread of `component`, in a cycle or not. Sleeps until `over()`, which it asks after each
/// ring, until `deadline`, or until the component may not wait any more. It hands on work that was
/// rung for to the next cycle.
template <class Over>
void sleepUntil(Component& component, Time deadline, const Over& over) {
  component.ringNow();
  struct HandOn {  // works also when over() throws
    ~HandOn() {
      if (work) bell.ring();
    }
    rt::Doorbell& bell;
    bool work = false;
  } rung{component.doorbell()};
  while (!over() && now() < deadline && component.mayWait()) {
    if (rung.bell.waitUntil(deadline) == rt::RungFor::Work) rung.work = true;
  }
}

}  // namespace suture
