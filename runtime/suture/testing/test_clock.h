#pragma once
// This is a clock that a test steps, and the order in which the threads of its process run.

#include <suture/base/time.h>
#include <suture/testing/trace.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace suture {

namespace testing_detail {
class OneProcessor;
class Scheduler;
}  // namespace testing_detail

/// Says how the threads of the process run while a TestClock exists.
enum class Threads : std::uint8_t {
  /// They take turns, in an order that depends only on the program and the seed, and all run on the
  /// processor on which the clock is made, where taking turns costs least.
  OneAtATime,
  /// All that have something to do run, as in production and for ThreadSanitizer. There is no
  /// trace.
  Together,
};

struct TestClockOptions {
  Threads threads = Threads::OneAtATime;
  /// 0: among threads that may run, the one with the earliest deadline comes first, then the one
  /// that was rung first, then the one that was started first. Any other number chooses by chance,
  /// repeatably.
  std::uint64_t seed = 0;
  /// Keeps what happens for TestClock::trace(). An hour of a system takes gigabytes.
  bool traced = false;
  /// The process may run this long in real time while none of its threads sleeps or is woken; then
  /// they are named on standard error.
  std::chrono::nanoseconds patience = std::chrono::seconds(10);
  /// The clock calls this when something happens that must not: a thread found work for which
  /// nobody had rung, or nothing can happen any more. May be called in any thread. Without it, the
  /// program is aborted.
  std::function<void(const std::string&)> problem = nullptr;
};

/// Takes the place of the process's clock while it exists, and of the kernel where a thread of
/// Suture sleeps. Time stands still while any thread runs, a ring is pending or a socket has
/// something; then it goes on to the next deadline at once. So a test of seconds takes
/// milliseconds, and its result does not depend on the machine.
///
/// Belongs to the thread that makes it, which is the test's. It is made before anything of Suture
/// in the process, and destroyed after that. Two managers of one process are both ends of every
/// lane, on Unix sockets. Another process cannot follow the clock: a connection to one is refused.
/// The kernel's own timers, TCP's among them, do not follow it either.
///
/// A thread that the test has made itself runs whenever it can, and sleeps on this clock where it
/// waits for Suture; see Hold. A thread that does not sleep for ten seconds of real time
/// (TestClockOptions::patience) is named on standard error.
class TestClock {
 public:
  /// Throws SetupError if the process has such a clock.
  explicit TestClock(TestClockOptions options = {});
  /// Throws nothing, but reports a problem if threads of Suture are left.
  ~TestClock();
  TestClock(const TestClock&) = delete;
  TestClock& operator=(const TestClock&) = delete;

  /// The test's thread. Lets everything happen that is due in the next `duration`, including its
  /// end.
  void advance(Duration duration);
  /// The test's thread. Lets time pass until `condition`, which is asked every kStep; returns false
  /// if it does not hold after `limit`.
  template <class Condition>
  bool until(const Condition& condition, Duration limit = std::chrono::seconds(10)) {
    const Time deadline = fromNow(limit);
    while (!condition()) {
      if (now() >= deadline) return false;
      advance(kStep);
    }
    return true;
  }
  static constexpr Duration kStep = std::chrono::microseconds(100);

  /// Any thread of Suture. Makes its cycle take `duration` longer; others run meanwhile.
  static void spend(Duration duration);

  /// Any thread. Suspends the machine for `duration`: all of its processes stand still, and so does
  /// now(), while the clock that goes on then (BootClock) goes on. So a handler that calls this is
  /// one in which the machine slept.
  void suspend(Duration duration);

  /// Returns everything that the threads have done, in order; empty if they run together. Throws
  /// SetupError unless the clock is traced.
  const Trace& trace() const;

  /// While it lives, time stands still even if nothing runs. Use it for what a thread that the test
  /// has made itself, or another process, will bring.
  class Hold {
   public:
    explicit Hold(TestClock& clock);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    TestClock& clock_;
  };

  /// A Process is a group of threads that stand still together, like those of a process that a
  /// debugger has stopped, or those of another machine. Threads of the test use it.
  class Process {
   public:
    explicit Process(TestClock& clock);
    /// Does `work`; all threads that it starts, and those that they start, belong to this process.
    void run(const std::function<void()>& work);
    /// Stops its threads, wherever they sleep or spend time. With Threads::Together one that runs
    /// goes on until it sleeps.
    void freeze();
    /// Lets them go on, later than they were due.
    void thaw();

   private:
    testing_detail::Scheduler& scheduler_;
    const std::size_t number_;
  };

 private:
  std::unique_ptr<testing_detail::OneProcessor> processor_;  // if threads take turns
  std::unique_ptr<testing_detail::Scheduler> scheduler_;
};

}  // namespace suture
