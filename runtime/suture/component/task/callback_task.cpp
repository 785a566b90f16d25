#include <suture/component/task/callback_task.h>

namespace suture {

void CallbackTask::start() {
  if (running_ && state() == ComponentState::Faulted) return;
  if (running_) requireLegal(name(), state(), Transition::Start);
  prepare();
  enter();
  restUntilTriggered();
  releaseThread();
  running_ = true;
}

void CallbackTask::stop() {
  refuseToStopInCycle();
  setEnding(true);
  doorbell().ring();  // its cycle may wait for an event that no thread handles any more
  if (!running_.exchange(false)) return;
  while (cycling_.test_and_set(std::memory_order_seq_cst)) cycleEnded_.wait();
  claimThread();
  leave();
  mutableActivity().suspend();
  cycling_.clear(std::memory_order_release);
}

// Gives no due time, since the task does not know when it is called next.
void CallbackTask::restUntilTriggered() {
  if (allRest()) {
    mutableActivity().suspend();
  } else {
    mutableActivity().sleep();
  }
}

// stop() clears running_ before it looks for a cycle under way, and all of these accesses have one
// order: either stop() sees that this cycle has ended, or this sees that it has to ring.
void CallbackTask::endCycle() {
  cycling_.clear(std::memory_order_seq_cst);
  if (!running_.load(std::memory_order_seq_cst)) cycleEnded_.ring();
}

bool CallbackTask::trigger() {
  if (cycling_.test_and_set(std::memory_order_acquire)) {
    mutableStatistics().skipped.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  const bool started = running_.load(std::memory_order_acquire);
  const bool runs = started && !ending() && state() == ComponentState::Running;
  if (started) {
    claimThread();
    cycle();
    restUntilTriggered();
  }
  endCycle();
  return runs;
}

}  // namespace suture
