#include <suture/component/task/thread_task.h>

#include <suture/base/virtual_time.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace suture {

ThreadTask::~ThreadTask() {
  if (!thread_.joinable()) return;
  // It is too late to stop the thread here: run() is gone with the derived class.
  std::fprintf(stderr,
               "the task '%s' is destroyed while its thread runs. Stop the task or its manager "
               "before; a manager that is declared after its components ends before them.\n",
               name().c_str());
  std::terminate();
}

void ThreadTask::start() {
  if (thread_.joinable() && state() == ComponentState::Faulted) return;
  if (thread_.joinable()) requireLegal(name(), state(), Transition::Start);
  prepare();
  refused_ = nullptr;
  thread_.start(name(), [this] { configureAndLoop(); });
  entered_.wait();
  if (refused_ == nullptr) return;
  thread_.join();
  std::rethrow_exception(refused_);
}

void ThreadTask::configureAndLoop() {
  processor_.begin();
  try {
    rt::configureThisThread(name(), scheduling_);
    enter();
  } catch (...) {
    refused_ = std::current_exception();
  }
  const bool runs = refused_ == nullptr;
  entered_.ring();
  if (runs) loop();
  processor_.end();
}

void ThreadTask::stop() {
  refuseToStopInCycle();
  if (!thread_.joinable()) return;
  setEnding(true);
  stopBell_.ring();
  doorbell().ring();
  thread_.join();
}

void ThreadTask::loop() {
  beginCycles();
  while (!ending()) {
    if (allRest()) {
      mutableActivity().suspend();
      awaitWork();
      cycle();
      if (!allRest()) beginCycles();
    } else if (awaitCycle()) {
      cycle();
    }
  }
  leave();
  mutableActivity().suspend();
}

// A ring may come without work to do: a client asks for the first time for a read of an interface
// that is served in every state.
void ThreadTask::awaitWork() {
  if (!ending() && !workPending()) sleepForWork(Time::max());
}

// While time is virtual every task also looks by itself from time to time, which finds work that
// nobody has rung for.
void ThreadTask::sleepForWork(Time due) {
  VirtualTime* const time = virtualTime();
  if (time != nullptr) due = std::min(due, now() + rt::Doorbell::kLookAgain);
  const bool rung = doorbell().waitUntil(due) != rt::RungFor::Nothing;
  if (time != nullptr && !rung && workPending()) time->missedRing(name());
}

}  // namespace suture
