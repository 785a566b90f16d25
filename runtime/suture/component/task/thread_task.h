#pragma once
// This is a task with its own thread.

#include <suture/component/task/task.h>
#include <suture/rt/processor_clock.h>
#include <suture/rt/scheduling.h>
#include <suture/rt/thread.h>

#include <atomic>
#include <exception>

namespace suture {

/// Runs its cycles in its own thread; the kinds derived from it say when.
class ThreadTask : public Task {
 public:
  ~ThreadTask() override;

  bool schedule(const rt::Scheduling& scheduling) final {
    scheduling_ = scheduling;
    return true;
  }
  std::optional<rt::Scheduling> scheduling() const final { return scheduling_; }

  std::optional<Duration> processorTime() const final { return processor_.used(); }

  /// Throws errors of scheduling here, in the caller's thread.
  void start() final;
  void stop() final;

 protected:
  explicit ThreadTask(const rt::Scheduling& scheduling) : scheduling_(scheduling) {}

  /// Waits for the next cycle; returns false when the task is to end.
  virtual bool awaitCycle() = 0;
  /// Called in the thread before the first awaitCycle(), and before the first after a rest.
  virtual void beginCycles() {}

  /// Sleeps until something rings, at the latest until `due`, which exists in case a ring is lost.
  void sleepForWork(Time due);

  /// Returns the bell that only stop() rings.
  rt::Doorbell& stopBell() { return stopBell_; }

 private:
  void configureAndLoop();
  void loop();
  void awaitWork();

  rt::Scheduling scheduling_;
  rt::Thread thread_;
  rt::ProcessorClock processor_;
  rt::Doorbell entered_;
  std::exception_ptr refused_;  // why the thread could not be configured; read after entered_
  rt::Doorbell stopBell_;
};

}  // namespace suture
