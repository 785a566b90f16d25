#include <suture/component/callback_task.h>

#include <thread>

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
  if (!running_.exchange(false)) return;
  while (cycling_.test_and_set(std::memory_order_acquire)) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  claimThread();
  leave();
  mutablePulse().suspend();
  cycling_.clear(std::memory_order_release);
}

// When it is called next, nobody here knows.
void CallbackTask::restUntilTriggered() {
  if (allRest()) {
    mutablePulse().suspend();
  } else {
    mutablePulse().sleep();
  }
}

bool CallbackTask::trigger() {
  if (cycling_.test_and_set(std::memory_order_acquire)) {
    mutableStatistics().skipped.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  const bool started = running_.load(std::memory_order_acquire);
  const bool runs = started && state() == ComponentState::Running;
  if (started) {
    claimThread();
    cycle();
    restUntilTriggered();
  }
  cycling_.clear(std::memory_order_release);
  return runs;
}

}  // namespace suture
