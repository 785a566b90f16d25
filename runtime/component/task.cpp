#include <suture/base/errors.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task.h>

#include <algorithm>
#include <future>

namespace suture {

Task::~Task() {
  // Too late to stop: run() is gone with the derived class. Whoever started the task stops it
  // before.
  if (thread_.joinable()) std::terminate();
}

void Task::start() {
  if (thread_.joinable()) return;
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
    claimForThisThread();
    setState(ComponentState::Running);
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

void Task::stop() {
  if (!thread_.joinable()) return;
  stopping_ = true;
  stopBell_.ring();
  doorbell().ring();
  thread_.join();
  for (ProvidedBase* interface : provided()) interface->announce(ChannelStatus::Lost);
  if (state() == ComponentState::Running) setState(ComponentState::Stopped);
  releaseThread();
}

void Task::loop() {
  try {
    beginCycles();
    while (awaitCycle()) cycle();
  } catch (const std::exception& error) {
    park(error.what());
  } catch (...) {
    park("an exception that is not a std::exception");
  }
  if (state() == ComponentState::Faulted) waitParked();
}

void Task::cycle() {
  const Time begin = now();
  handleEvents();
  for (ProvidedBase* interface : provided()) interface->drain();
  run();
  for (ProvidedBase* interface : provided()) interface->publishRow();
  ringNow();
  statistics_.computeTime.record(now() - begin);
  statistics_.cycles.store(statistics_.cycles.load(std::memory_order_relaxed) + 1,
                           std::memory_order_relaxed);
}

void Task::waitParked() {
  ringNow();
  while (!stopping()) stopBell_.waitUntil(now() + std::chrono::seconds(1));
}

bool Task::workPending() const {
  const auto pending = [](const auto* interface) { return interface->pending(); };
  return std::any_of(provided().begin(), provided().end(), pending) ||
         std::any_of(required().begin(), required().end(), pending);
}

}  // namespace suture
