#pragma once
// An active component: the common part of all tasks.

#include <suture/component/component.h>
#include <suture/component/task/task_activity.h>
#include <suture/component/task/task_window.h>
#include <suture/rt/histogram.h>
#include <suture/rt/scheduling.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suture {

class GuestTask;

/// How often a faulted task is restarted: `most` times in any time of length `per`.
struct RestartBudget {
  static constexpr unsigned kMost = 16;

  unsigned most = 0;
  Duration per{};
};

/// Measurements of a task's loop: since it exists, and over its last window. Written by its thread,
/// readable by any.
struct TaskStatistics {
  std::atomic<std::uint64_t> cycles{0};
  std::atomic<std::uint64_t> skipped{0};  ///< periods or callbacks that passed without a cycle
  rt::Histogram lateness;                 ///< wake-up time minus due time
  rt::Histogram computeTime;              ///< length of a cycle, without those of guests
  WindowMeter windows;                    ///< windows.last(): mean, deviation, min, max, p99
};

/// Works in cycles, one at a time. Each cycle: take over new connections, run event handlers,
/// execute waiting commands, run(), publish the reads that somebody asked for, ring those who
/// sleep; then the guests have theirs. In steady state a cycle neither allocates nor locks nor
/// touches the network. A handler that throws parks this component and nothing else.
///
/// While it is suspended its cycles consist of turning away commands, which are answered
/// Errc::Suspended and never executed; events wait in their queues. Its thread sleeps unless
/// something arrives.
class Task : public Component {
 public:
  /// The manager's: configures what has not been, then cycles run; those of a faulted task only
  /// tell so. Throws SetupError if they cannot run, or if it runs already.
  virtual void start() = 0;
  /// The manager's: returns after the handler under way, or run(); no other begins. What waits is
  /// answered Errc::Lost. The derived class must still exist.
  virtual void stop() = 0;

  /// Before start(), and before `guest` is connected: from now on a cycle of `guest` follows each
  /// of this task's, in the same thread; several guests run in the order in which they were lent
  /// to. Throws SetupError. The guest outlives the last cycle.
  void lend(GuestTask& guest);

  /// Before start(): schedules its thread so, instead of as its constructor was told. False, and
  /// nothing changes, if its cycles run in the thread of somebody else.
  virtual bool schedule(const rt::Scheduling& /*scheduling*/) { return false; }
  /// How its thread is scheduled once it runs; none if that is somebody else's.
  virtual std::optional<rt::Scheduling> scheduling() const { return std::nullopt; }

  /// What its thread has had of the processors so far; none if its cycles run in the thread of
  /// somebody else. Any thread.
  virtual std::optional<Duration> processorTime() const { return std::nullopt; }

  const TaskStatistics& statistics() const { return statistics_; }
  /// Whether its thread works, sleeps or hangs: that of its host, if it is a guest. Any thread.
  const TaskActivity& activity() const {
    return lender_ == nullptr ? activity_ : static_cast<const Task*>(lender_)->activity();
  }
  /// Before start(): a fault is followed by onFault() and then by a restart, as long as the budget
  /// lasts; then the task stays faulted. Without, it stays so at once. Throws SetupError for more
  /// than RestartBudget::kMost.
  void restartAfterFaults(const RestartBudget& budget);
  /// Any thread: true if no restart follows the fault that it is in: the budget is used up, there
  /// is none, or onFault() threw.
  bool staysFaulted() const { return staysFaulted_.load(std::memory_order_acquire); }
  /// Before start(): the length of the windows of statistics(), 1 s without. Throws SetupError.
  void measureOver(Duration window) { statistics_.windows.setLength(window); }

 protected:
  Task() : Component(true) {}

  /// The component's own work of one cycle.
  virtual void run() = 0;
  /// Its safe state: called in its thread once it has been faulted, by what a hook or handler threw
  /// or by the contract of a connection (docs/safety.md), after its clients have been told. Its
  /// required interfaces still work: the place to tell arms to hold, brakes to close. If it throws,
  /// the task is not restarted.
  virtual void onFault() {}

  // --- for the kinds of task ---

  /// Before enter(), in the manager's thread: configures this task and its guests if that has not
  /// been done.
  void prepare();
  /// Before the first cycle: it and its guests run from here on, in the calling thread.
  void enter();
  /// The next cycle is the calling thread's, for guests too.
  void claimThread();
  /// One cycle, and one of each guest.
  void cycle();
  /// After the last cycle, in its thread: clients of this task and its guests are told that they
  /// are lost.
  void leave();

  /// True if commands, events or connections wait to be handled, here or by a guest.
  bool workPending() const;
  /// True if neither this task nor any guest has a run() to call: suspended, or its code threw.
  bool allRest() const;
  TaskStatistics& mutableStatistics() { return statistics_; }
  /// For its thread, around each sleep; a cycle says itself when it begins.
  TaskActivity& mutableActivity() { return activity_; }

 private:
  friend class GuestTask;

  void take(Transition transition) final;
  void parkSoon(std::string reason) final;
  void parkIfAsked();
  void makeRequestedTransition();
  void makeSafe();
  bool tryOnFault();
  bool mayRestart();
  bool goesOn() const;
  void work();
  void rest();
  bool ownWorkPending() const;
  bool isConnected() const;

  std::vector<GuestTask*> guests_;
  std::atomic<std::optional<Transition>> requested_{std::nullopt};
  // What the first call in another thread threw.
  std::atomic_flag failing_ = ATOMIC_FLAG_INIT;
  std::string failure_;
  std::atomic<bool> failed_{false};  // failure_ says why
  TaskStatistics statistics_;
  TaskActivity activity_;
  std::uint64_t safeAfter_ = 0;  // the fault that onFault() was called for
  std::atomic<bool> staysFaulted_{false};
  RestartBudget restarts_;
  std::array<Time, RestartBudget::kMost> restartedAt_{};  // by turns
  unsigned restartTurn_ = 0;
};

}  // namespace suture
