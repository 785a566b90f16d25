#pragma once
// This decides which thread of a process runs next, and when time goes on.

#include <suture/base/virtual_time.h>
#include <suture/testing/test_clock.h>
#include <suture/testing/trace.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace suture::testing_detail {

/// A ScheduledThread is a thread as the scheduler sees it, guarded by the scheduler's mutex.
struct ScheduledThread {
  enum class State : std::uint8_t { Runs, Ready, Sleeps };

  std::string name;
  std::size_t number = 0;   // in the order of starting
  std::size_t process = 0;  // which TestClock::Process it belongs to; 0: none
  State state = State::Ready;
  bool known = true;             // false: one that the test has made, which runs beside the others
  bool isTest = false;           // runs at its deadline after all others
  VirtualTime::Place place = 0;  // while it sleeps, unless it spends
  VirtualTime::Place home = 0;   // where it slept last
  std::vector<VirtualTime::Place> owes;     // whom it will wake at the end of its cycle
  VirtualTime::Sockets* sockets = nullptr;  // while it sleeps at any sockets
  Time deadline{};
  std::uint64_t rung = 0;      // which ring has made it ready; 0: its deadline
  std::uint64_t lookedAt = 0;  // the turn after which it has found nothing at its sockets
  bool looks = false;          // it has been woken in order to look at them
  std::condition_variable wakes;
};

/// Implements TestClock. Any thread.
class Scheduler final : public VirtualTime {
 public:
  explicit Scheduler(TestClockOptions options);
  ~Scheduler() = default;
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  Time now() const override { return fromNanoseconds(now_.load(std::memory_order_acquire)); }
  Duration suspended() const override { return suspended_.load(std::memory_order_acquire); }
  void sleep(const Sleeper& sleeper, Time deadline) override;
  void sleepAt(Sockets& sockets, const Sleeper& sleeper, Time deadline) override;
  void wake(Place place) override;
  void spend(Duration duration) override;
  std::size_t announce(const std::string& name) override;
  void begin(std::size_t thread) override;
  void end() override;
  void retract(std::size_t thread) override;
  void note(Kind kind, const char* interface, const char* what, std::uint64_t number) override;
  void owe(Place place) override;
  void settle() override;
  void missedRing(const std::string& name) override;

  // --- the rest is for TestClock ---

  /// Makes the calling thread the test's.
  void adoptTest();
  void finish();
  void hold();
  void release();
  /// Lets the boot clock go on by so much more than the steady one.
  void suspend(Duration duration);
  std::size_t addProcess() { return ++processes_; }
  /// Makes all that the calling thread starts from now on, and what that starts, part of `process`.
  static void enterProcess(std::size_t process);
  void freeze(std::size_t process);
  void thaw(std::size_t process);
  bool isTraced() const { return options_.traced; }
  const Trace& trace() const { return trace_; }

 private:
  using Thread = ScheduledThread;
  using Lock = std::unique_lock<std::mutex>;

  Thread& add(const std::string& name);
  void sleepAs(Thread& thread, Lock& lock);
  void await(Thread& thread, Lock& lock);
  Thread& enter();
  void leave(Thread& thread);
  bool sleepUnlessWoken(Thread& thread, const Sleeper& sleeper, Time deadline, Lock& lock);
  void dispatch();
  void grant(Thread& thread);
  void makeReady(Thread& thread, std::uint64_t ring);
  bool isFrozen(const Thread& thread) const { return frozen_.contains(thread.process); }
  Thread* nextReady();
  Thread* nextToLook();
  Thread* nextLast();
  bool goOn();
  std::string describe() const;
  void report(const std::string& problem);

  const TestClockOptions options_;
  const Time begin_;
  std::atomic<std::int64_t> now_;
  std::atomic<Duration> suspended_{Duration{0}};
  mutable std::mutex mutex_;
  std::map<std::size_t, std::unique_ptr<Thread>> threads_;  // by number
  std::size_t started_ = 0;
  std::size_t running_ = 0;  // how many of those that are known
  std::uint64_t turns_ = 1;  // how often any thread has been given something to do
  std::uint64_t rings_ = 0;
  std::uint64_t namedAtTurn_ = 0;
  unsigned holds_ = 0;
  std::size_t processes_ = 0;
  std::set<std::size_t> frozen_;  // processes
  std::mt19937_64 chance_;
  Trace trace_;
};

}  // namespace suture::testing_detail
