#pragma once
// A task is an active component; this is the common part of all kinds.

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

/// Limits how often a faulted task is restarted: `most` times in any time of length `per`.
struct RestartBudget {
  static constexpr unsigned kMost = 16;

  unsigned most = 0;
  Duration per{};
};

/// The task's thread writes it, and any may read it. Measures a task's loop: since it exists, and
/// over its last window.
struct TaskStatistics {
  std::atomic<std::uint64_t> cycles{0};
  std::atomic<std::uint64_t> skipped{0};  ///< periods or callbacks that passed without a cycle
  rt::Histogram lateness;                 ///< wake-up time minus due time
  rt::Histogram computeTime;              ///< length of a cycle, without those of guests
  WindowMeter windows;                    ///< windows.last(): mean, deviation, min, max, p99
};

/// Works in cycles, one at a time. Each cycle takes over new connections, runs event handlers,
/// executes waiting commands, calls run(), publishes the reads that clients asked for, and rings
/// those who sleep; then the guests run theirs. In steady state a cycle neither allocates nor locks
/// nor touches the network. A handler that throws parks this component and nothing else.
///
/// While it is suspended its cycles only refuse commands, which are answered Errc::Suspended and
/// never executed; events wait in their queues. Its thread sleeps unless something arrives.
class Task : public Component {
 public:
  /// The manager calls this: configures what is not configured, then cycles run; those of a faulted
  /// task only refuse commands. Throws SetupError if they cannot run, or if it runs already.
  virtual void start() = 0;
  /// The manager calls this: returns after the handler under way, or run(); no other begins. What
  /// waits is answered Errc::Lost. The derived class must still exist. Throws SetupError as
  /// refuseToStopInCycle() does.
  virtual void stop() = 0;
  /// Any thread. Throws SetupError in a hook, handler or run() of this task, or of a guest, because
  /// stop() would wait there for itself.
  void refuseToStopInCycle();

  /// Before start(), and before `guest` is connected: from now on a cycle of `guest` follows each
  /// of this task's, in the same thread; several guests run in the order in which they were lent
  /// to. Throws SetupError. The guest must outlive the last cycle.
  void lend(GuestTask& guest);

  /// Before start(): schedules its thread like this, instead of as its constructor said. Returns
  /// false, and changes nothing, if its cycles run in a thread that is not its own.
  virtual bool schedule(const rt::Scheduling& /*scheduling*/) { return false; }
  /// Returns how its thread is scheduled once it runs, or none if that is not its own.
  virtual std::optional<rt::Scheduling> scheduling() const { return std::nullopt; }

  /// Any thread. Returns the processor time that its thread has used, or none if its cycles run in
  /// a thread that is not its own.
  virtual std::optional<Duration> processorTime() const { return std::nullopt; }

  /// Any thread. Returns how its cycles have gone so far, counted since the task was made.
  const TaskStatistics& statistics() const { return statistics_; }
  /// Any thread. Tells if its thread, or its host's if it is a guest, works, sleeps or hangs.
  const TaskActivity& activity() const {
    return lender_ == nullptr ? activity_ : static_cast<const Task*>(lender_)->activity();
  }
  /// Before start(): after a fault onFault() is called, and then the task is restarted, as long as
  /// the budget lasts. After that the task stays faulted. It stays so at once without a budget, or
  /// if the fault came while it was configured, started or suspended.
  /// The restart waits while a provider is lost and the contract of its connection has on_loss
  /// Fault. Throws SetupError for more than RestartBudget::kMost, or if `per` is not greater than
  /// zero.
  void restartAfterFaults(const RestartBudget& budget);
  /// Any thread. Returns true if no restart follows the fault that it is in: the budget is used up,
  /// there is none, it was not running, it is to stop, or onFault() threw.
  bool staysFaulted() const { return staysFaulted_.load(std::memory_order_acquire); }
  /// Before start(): sets the length of the windows of statistics(), which is 1 s without this.
  /// Throws SetupError.
  void measureOver(Duration window) { statistics_.windows.setLength(window); }

 protected:
  Task() : Component(true) {}

  /// Does the component's own work of one cycle.
  virtual void run() = 0;
  /// Enters the safe state. It is called in the task's thread after a hook or handler threw, or the
  /// contract of a connection faulted it (docs/safety.md), and after its clients have been told.
  /// Its required interfaces still work: tell arms to hold and brakes to close here. If it throws,
  /// the task is not restarted.
  virtual void onFault() {}

  // --- for the kinds of task ---

  /// The manager's thread, before enter(): configures this task and its guests if that has not been
  /// done.
  void prepare();
  /// Before the first cycle: from here on this task and its guests run in the calling thread.
  void enter();
  /// Makes the next cycle, and that of the guests, the calling thread's.
  void claimThread();
  /// Runs one cycle, and one of each guest.
  void cycle();
  /// The task's thread, after the last cycle: tells clients of this task and its guests that they
  /// have lost it.
  void leave();

  /// Returns true if commands, events or connections wait to be handled, here or by a guest.
  bool workPending() const;
  /// Returns true if neither this task nor any guest has a run() to call: it is suspended, or its
  /// code threw.
  bool allRest() const;
  TaskStatistics& mutableStatistics() { return statistics_; }
  /// Its thread calls this around each sleep; a cycle notes its own beginning.
  TaskActivity& mutableActivity() { return activity_; }

 private:
  friend class GuestTask;

  class InCycle;

  void take(Transition transition) final;
  void parkSoon(std::string reason) final;
  void parkIfAsked();
  bool requestDue() const;
  void makeRequestedTransition();
  void makeSafe();
  bool tryOnFault();
  bool budgetLasts();
  /// Returns true while a provider is lost and the contract of its connection has on_loss Fault:
  /// then the task must not run.
  bool lacksProvider();
  bool goesOn() const;
  void work();
  void rest();
  void refuseWaiting();
  bool ownWorkPending() const;
  bool isConnected() const;

  std::vector<GuestTask*> guests_;
  std::atomic<bool> inCycle_{false};  // its code may run, in the thread that owns it
  std::atomic<std::optional<Transition>> requested_{std::nullopt};
  // The first call in another thread threw this.
  std::atomic_flag failing_ = ATOMIC_FLAG_INIT;
  std::string failure_;
  std::atomic<bool> failed_{false};  // failure_ says why
  TaskStatistics statistics_;
  TaskActivity activity_;
  std::uint64_t safeAfter_ = 0;  // the fault that onFault() was called for
  bool awaitsRestart_ = false;
  std::atomic<bool> staysFaulted_{false};
  RestartBudget restarts_;
  std::array<Time, RestartBudget::kMost> restartedAt_{};  // a ring of the last restarts
  unsigned restartTurn_ = 0;
};

}  // namespace suture
