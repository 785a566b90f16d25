#include <suture/component/thread_task.h>

#include <exception>
#include <future>

namespace suture {

ThreadTask::~ThreadTask() {
  // Too late to stop: run() is gone with the derived class. Whoever started the task stops it
  // before.
  if (thread_.joinable()) std::terminate();
}

void ThreadTask::start() {
  if (thread_.joinable() && state() == ComponentState::Faulted) return;
  if (thread_.joinable()) requireLegal(name(), state(), Transition::Start);
  prepare();
  stopping_ = false;
  std::promise<void> configured;
  auto outcome = configured.get_future();
  thread_ = std::thread([this, &configured] {
    try {
      rt::configureThisThread(name(), scheduling_);
    } catch (...) {
      configured.set_exception(std::current_exception());
      return;
    }
    enter();
    configured.set_value();
    loop();
  });
  try {
    outcome.get();
  } catch (...) {
    thread_.join();
    throw;
  }
}

void ThreadTask::stop() {
  if (!thread_.joinable()) return;
  stopping_ = true;
  stopBell_.ring();
  doorbell().ring();
  thread_.join();
}

void ThreadTask::loop() {
  beginCycles();
  while (!stopping()) {
    if (allRest()) {
      mutablePulse().suspend();
      awaitWork();
      cycle();
      if (!allRest()) beginCycles();
    } else if (awaitCycle()) {
      cycle();
    }
  }
  leave();
  mutablePulse().suspend();
}

// A ring may announce what is not work pending: somebody asks for the first time for a read of an
// interface that is served in every state.
void ThreadTask::awaitWork() {
  if (!stopping() && !workPending()) doorbell().waitUntil(now() + std::chrono::seconds(1));
}

}  // namespace suture
