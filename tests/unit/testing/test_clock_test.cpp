#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <suture/base/boot_time.h>
#include <suture/base/errors.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/thread.h>
#include <suture/testing/test_clock.h>

#include <poll.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "support/refusal.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Counts its cycles, each of which takes `length`.
struct Counter final : PeriodicTask {
  explicit Counter(Duration period, Duration length = {})
      : PeriodicTask({.period = period}), length_(length) {}
  ~Counter() override { stop(); }
  void run() override {
    ++cycles;
    if (length_ > Duration{}) TestClock::spend(length_);
  }
  std::atomic<int> cycles{0};

 private:
  const Duration length_;
};

TEST(TestClock, StandsStillUntilItIsStepped) {
  TestClock clock;
  const Time begin = now();
  EXPECT_EQ(now(), begin);
  clock.advance(5ms);
  EXPECT_EQ(now() - begin, 5ms);
}

TEST(TestClock, SuspendsTheMachine) {
  TestClock clock;
  const Time begin = now();
  const BootTime boot = BootClock::now();
  clock.suspend(1h);
  EXPECT_EQ(now(), begin);
  EXPECT_EQ(BootClock::now() - boot, 1h);
  clock.advance(1ms);
  EXPECT_EQ(now() - begin, 1ms);
  EXPECT_EQ(BootClock::now() - boot, 1h + 1ms);
}

TEST(TestClock, IsTheOnlyOneOfItsProcess) {
  TestClock clock;
  EXPECT_EQ(refusal([] { TestClock(); }),
            "making a TestClock: this process has one. Destroy that first");
  clock.advance(1ms);
}

TEST(TestClock, KeepsATraceOnlyOnRequest) {
  TestClock clock;
  EXPECT_EQ(refusal([&] { (void)clock.trace(); }),
            "reading the trace of a TestClock: it keeps none. Make it with "
            "TestClockOptions::traced");
}

TEST(TestClock, LeavesTheKernelsClockBehind) {
  { TestClock clock; }
  EXPECT_EQ(virtualTime(), nullptr);
  const Time begin = now();
  EXPECT_GE(Clock::now(), begin);
}

TEST(TestClock, RunsAPeriodicTaskEachPeriod) {
  TestClock clock;
  Counter counter(1ms);
  counter.start();
  clock.advance(3600s / 100);
  EXPECT_EQ(counter.cycles, 36'000);
  EXPECT_EQ(counter.statistics().skipped, 0u);
}

TEST(TestClock, SkipsPeriodsOfALongCycle) {
  TestClock clock;
  Counter counter(1ms, 2500us);
  counter.start();
  clock.advance(30ms);
  EXPECT_EQ(counter.cycles, 10);
  EXPECT_EQ(counter.statistics().skipped, 18u);  // the last cycle has not ended yet
}

/// Writes its name down in each cycle.
struct Named final : PeriodicTask {
  Named(Duration period, std::string called, std::vector<std::string>& all)
      : PeriodicTask({.period = period}), called_(std::move(called)), all_(all) {}
  ~Named() override { stop(); }
  void run() override { all_.push_back(called_); }

 private:
  const std::string called_;
  std::vector<std::string>& all_;
};

TEST(TestClock, RunsThreadsByTheirDeadlines) {
  TestClock clock;
  std::vector<std::string> order;
  Named slow(3ms, "slow", order), fast(2ms, "fast", order);
  slow.start();
  fast.start();
  clock.advance(6ms);
  EXPECT_THAT(order, testing::ElementsAre("fast", "slow", "fast", "slow", "fast"));
}

TEST(TestClock, HoldsTimeForATestsThread) {
  TestClock clock;
  Counter counter(1ms);
  counter.start();
  std::atomic<bool> done{false};
  rt::Doorbell bell;
  TestClock::Hold hold(clock);
  std::thread other([&] {
    EXPECT_EQ(counter.cycles, 0);  // a second of real time would have brought a thousand
    done = true;
    bell.ring();
  });
  bell.wait();
  EXPECT_TRUE(done);
  EXPECT_EQ(counter.cycles, 0);
  other.join();
}

void leaveAThread() {
  rt::Thread thread;
  TestClock clock;
  thread.start("left over", [] { TestClock::spend(1h); });
  clock.advance(1ms);
}

TEST(TestClockDeathTest, NamesThreadsThatAreLeft) {
  EXPECT_DEATH(leaveAThread(), "'left over' sleeps for");
}

TEST(TestClock, TellsThatNothingCanHappenAnyMore) {
  rt::Doorbell bell;
  std::vector<std::string> problems;
  TestClock clock({.patience = 10ms, .problem = [&](const std::string& one) {
                     problems.push_back(one);
                     bell.ring();
                   }});
  bell.wait();
  EXPECT_THAT(problems, testing::ElementsAre("nothing can happen any more:\n  'test' sleeps until "
                                             "it is rung"));
}

/// Keeps what the process writes to standard error from now on.
class HeardErrors {
 public:
  HeardErrors() : before_(dup(STDERR_FILENO)) {
    if (pipe(ends_) != 0 || dup2(ends_[1], STDERR_FILENO) < 0) std::abort();
  }
  ~HeardErrors() {
    dup2(before_, STDERR_FILENO);
    for (const int one : {before_, ends_[0], ends_[1]}) close(one);
  }
  /// Waits for the kernel, of which a stepped clock does not know.
  std::string next() const {
    char text[1024];
    return {text,
            static_cast<std::size_t>(std::max<ssize_t>(read(ends_[0], text, sizeof(text)), 0))};
  }

 private:
  const int before_;
  int ends_[2];
};

TEST(TestClock, NamesAThreadThatDoesNotSleep) {
  const HeardErrors errors;
  TestClock clock({.patience = 10ms});
  std::string heard;
  rt::Thread thread;
  // On a busy machine the test's own thread may be told of first.
  thread.start("busy", [&] {
    while (heard.find("'busy' runs") == std::string::npos) heard += errors.next();
  });
  clock.advance(1ms);
  thread.join();
  EXPECT_THAT(heard, testing::HasSubstr("suture: for 0.01 s of real time no thread has slept:"));
  EXPECT_THAT(heard, testing::HasSubstr("\n  'busy' runs"));
}

// If it did not, a process that was stopped for long would go on in the order in which its threads
// began.
TEST(TestClock, RunsLateThreadsByTheirDeadlines) {
  TestClock clock;
  std::vector<std::string> order;
  TestClock::Process process(clock);
  std::optional<Named> slow, fast;
  process.run([&] {
    slow.emplace(8ms, "slow", order).start();
    fast.emplace(5ms, "fast", order).start();
  });
  clock.advance(1ms);
  process.freeze();
  clock.advance(9ms);
  EXPECT_TRUE(order.empty());
  process.thaw();
  clock.advance(1ms);
  EXPECT_THAT(order, testing::ElementsAre("fast", "slow"));
}

/// A thread that sleeps at a pipe, and is woken by each byte.
class Listener final : VirtualTime::Sockets {
 public:
  Listener() {
    if (pipe(ends_) != 0) std::abort();
    thread_.start(
        "listener", [this] { listen(); }, rt::Thread::Signals::None);
  }
  ~Listener() {
    over_ = true;
    bell_.ring();
    thread_.join();
    close(ends_[0]);
    close(ends_[1]);
  }
  void send() {
    if (write(ends_[1], "x", 1) != 1) std::abort();
  }
  std::atomic<int> looks{0}, heard{0};

 private:
  void listen() {
    while (!over_) {
      bell_.sleepAt(*this, Time::max());
      bell_.takeRing();
      for (char byte; mayFind() && read(ends_[0], &byte, 1) == 1;) ++heard;
    }
  }
  bool look() override {
    ++looks;
    return mayFind();
  }
  bool mayFind() override {
    pollfd end{.fd = ends_[0], .events = POLLIN, .revents = 0};
    return poll(&end, 1, 0) > 0;
  }

  int ends_[2];
  rt::Doorbell bell_;
  std::atomic<bool> over_{false};
  rt::Thread thread_;
};

TEST(TestClock, WakesAThreadOnlyForArrivedBytes) {
  TestClock clock;
  Listener listener;
  Counter counter(1ms);
  counter.start();
  clock.advance(100ms);
  EXPECT_EQ(listener.looks, 0);
  listener.send();
  const Time sent = now();
  EXPECT_TRUE(clock.until([&] { return listener.heard == 1; }));
  EXPECT_EQ(now() - sent, TestClock::kStep) << "time does not go on before it has been heard";
  EXPECT_EQ(listener.looks, 1);
}

int processors() {
  cpu_set_t allowed;
  sched_getaffinity(0, sizeof(allowed), &allowed);
  return CPU_COUNT(&allowed);
}

TEST(TestClock, KeepsTurnTakingThreadsOnOneProcessor) {
  const int before = processors();
  {
    TestClock clock;
    EXPECT_EQ(processors(), 1);
  }
  EXPECT_EQ(processors(), before);
  const TestClock clock({.threads = Threads::Together});
  EXPECT_EQ(processors(), before);
}

TEST(TestClock, SchedulesThreadsThatTakeTurnsInBatches) {
  const int before = sched_getscheduler(0);
  ASSERT_EQ(before, SCHED_OTHER);
  {
    TestClock clock;
    EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
    std::atomic<int> ofAnother{before};
    rt::Thread another;
    another.start("another", [&] { ofAnother = sched_getscheduler(0); });
    another.join();
    EXPECT_EQ(ofAnother, SCHED_BATCH);
  }
  EXPECT_EQ(sched_getscheduler(0), before);
}

TEST(TestClock, RunsThreadsTogetherIfAskedTo) {
  TestClock clock({.threads = Threads::Together});
  Counter one(1ms), other(1ms);
  one.start();
  other.start();
  clock.advance(100ms);
  EXPECT_EQ(one.cycles, 100);
  EXPECT_EQ(other.cycles, 100);
}

}  // namespace
}  // namespace suture
