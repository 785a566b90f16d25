#pragma once
// An active component: the common part of all tasks.

#include <suture/component/component.h>
#include <suture/rt/histogram.h>
#include <suture/rt/thread.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>

namespace suture {

/// Measurements of a task's loop. Written by its thread, readable by any.
struct TaskStatistics {
  std::atomic<std::uint64_t> cycles{0};
  std::atomic<std::uint64_t> skipped{0};  ///< periods that passed without a cycle
  rt::Histogram lateness;                 ///< wake-up time minus due time
  rt::Histogram computeTime;              ///< length of a cycle
};

/// Owns a thread. Each cycle: take over new connections, run event handlers, execute waiting
/// commands, run(), publish the reads that somebody asked for, ring those who sleep. In steady
/// state a cycle neither allocates nor locks nor touches the network. A handler that throws parks
/// this component and nothing else.
class Task : public Component {
 public:
  ~Task() override;

  bool ownsThread() const final { return true; }

  /// The manager's: starts the thread. Errors of scheduling are thrown here, in the caller's
  /// thread.
  void start();
  /// The manager's: ends the thread after the cycle under way. The derived class must still exist.
  void stop();

  const TaskStatistics& statistics() const { return statistics_; }

 protected:
  explicit Task(const rt::Scheduling& scheduling) : scheduling_(scheduling) {}

  /// The component's own work of one cycle.
  virtual void run() = 0;

  /// Waits for the next cycle; false when the task is to end. Written by the kinds of task.
  virtual bool awaitCycle() = 0;
  /// Called once in the thread before the first awaitCycle().
  virtual void beginCycles() {}

  bool stopping() const { return stopping_.load(std::memory_order_acquire); }
  /// Rung by stop() only.
  rt::Doorbell& stopBell() { return stopBell_; }
  /// True if commands, events or connections wait to be handled.
  bool workPending() const;
  TaskStatistics& mutableStatistics() { return statistics_; }

 private:
  void loop();
  void cycle();
  void waitParked();

  rt::Scheduling scheduling_;
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  rt::Doorbell stopBell_;
  TaskStatistics statistics_;
};

}  // namespace suture
