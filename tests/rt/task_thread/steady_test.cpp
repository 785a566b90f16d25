// A million cycles of the full Arm contract on the `local` lane cost nothing but time: no
// allocation, no lock, no system call, no page fault.

#include <gtest/gtest.h>
#include <sched.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>
#include <suture/wiring/connect.h>
#include <sys/mman.h>

#include <atomic>
#include <thread>

#include "rt/task_thread/arm_tasks.h"
#include "rt/task_thread/watch.h"

namespace proof {
namespace {

using Findings = std::vector<std::string>;

#ifdef SUTURE_UNWATCHED
constexpr std::uint64_t kCycles = 1'000, kSleepingCycles = 1'000, kWarmUp = 200;
#else
constexpr std::uint64_t kCycles = 1'000'000, kSleepingCycles = 100'000, kWarmUp = 2'000;
#endif

/// Locks the memory of the process, as real-time processes do (runtime/suture/deploy/real_time.h),
/// while it lives. Else a path that runs for the first time after minutes, because the machine
/// stood still, has a fault for its code. A user who may not lock it, and a sanitizer, whose memory
/// has no end, do without.
class LockedMemory {
 public:
#ifndef SUTURE_UNWATCHED
  LockedMemory() { (void)mlockall(MCL_CURRENT | MCL_FUTURE); }
  ~LockedMemory() { munlockall(); }
#else
  LockedMemory() {}
#endif
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;
};

bool eventuallyDone(const Watch& watch) {
  const suture::Time deadline = suture::now() + std::chrono::minutes(5);
  while (!watch.done() && suture::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return watch.done();
}

/// Returns a processor that this process may use: threads that wake each other are best off on one.
int someProcessor() {
  cpu_set_t set;
  sched_getaffinity(0, sizeof(set), &set);
  int last = 0;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) last = CPU_ISSET(cpu, &set) ? cpu : last;
  return last;
}

// Both tasks take turns in one thread, so every command is executed and every event arrives.
TEST(TaskThread, CyclesInOneThreadCostNothing) {
  const LockedMemory locked;
  ArmTask<suture::CallbackTask> arm;
  UserTask<suture::CallbackTask> client;
  const auto channel = suture::connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  Watch watch("the thread of both", kWarmUp, kCycles);
  std::thread([&] {
    while (!watch.done()) {
      client.trigger();
      arm.trigger();
      if (client.user.isWarm()) watch.cycle();
    }
  }).join();
  EXPECT_EQ(watch.findings(), Findings{});

  const ArmUser& user = client.user;
  EXPECT_EQ(user.refused, 0u);
  EXPECT_GE(user.commands, kCycles);
  EXPECT_GE(user.reads, 22 * kCycles);
  EXPECT_GE(user.answers, kCycles);
  EXPECT_GE(user.events, kCycles / 2);
  EXPECT_GE(channel->state->rows(), kCycles);
  EXPECT_EQ(channel->events.dropped(), 0u);
  const suture::rt::MailboxCounters& counters = channel->commands.counters;
  EXPECT_EQ(counters.executed + counters.late, counters.sent);
}

// There is no warm-up: what a command, an event or a read needs is there before its first use.
TEST(TaskThread, FirstUsesAllocateNothing) {
  ArmTask<suture::CallbackTask> arm;
  UserTask<suture::CallbackTask> client;
  suture::connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  Watch watch("the thread of both", 1, 2'000);
  client.also = [&] { watch.cycle(); };  // watches once the client has taken over the connection
  std::thread([&] {
    while (!watch.done()) {
      arm.trigger();
      client.trigger();
    }
  }).join();
  EXPECT_GT(client.user.events, 0u);
  for (const std::string& finding : watch.findings()) {
    const bool fault = finding.find("page fault") != std::string::npos;  // until memory is touched
    EXPECT_TRUE(fault) << finding;
  }
}

// Both run as fast as they can, on two processors if there are two; no thread ever sleeps.
TEST(TaskThread, CyclesOfTwoThreadsCostNothing) {
  const LockedMemory locked;
  ArmTask<suture::ContinuousTask> arm;
  UserTask<suture::ContinuousTask> client;
  Watch armWatch("PSM", kWarmUp, kCycles), clientWatch("Console", kWarmUp, kCycles);
  std::atomic<bool> warm{false};
  arm.also = [&] {
    if (warm) armWatch.cycle();
  };
  client.also = [&] {
    if (client.user.isWarm()) warm = true;
    if (warm) clientWatch.cycle();
  };
  const auto channel = suture::connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  EXPECT_TRUE(eventuallyDone(armWatch) && eventuallyDone(clientWatch));
  client.stop();
  arm.stop();
  EXPECT_EQ(armWatch.findings(), Findings{});
  EXPECT_EQ(clientWatch.findings(), Findings{});

  EXPECT_GT(channel->commands.counters.executed, 1000u);
  EXPECT_GT(client.user.events, 1000u);
  EXPECT_GT(client.user.answers, 1000u);
}

// An arm and two clients sleep whenever they have nothing to do, and wake each other. So each cycle
// costs one sleep, and one ring for each of the others that sleeps.
TEST(TaskThread, SleepingCyclesCostOnlyTheirSleep) {
  const LockedMemory locked;
  const suture::EventOptions options{.scheduling = {.processor = someProcessor()}};
  ArmTask<suture::EventTask> arm(options);
  UserTask<suture::EventTask> first(options), second(options);
  Watch armWatch("PSM", kWarmUp, kSleepingCycles, {.sleeps = 1, .wakes = 2});
  Watch firstWatch("Console 1", kWarmUp, kSleepingCycles, {.sleeps = 1, .wakes = 1});
  Watch secondWatch("Console 2", kWarmUp, kSleepingCycles, {.sleeps = 1, .wakes = 1});
  std::atomic<bool> warm{false};
  arm.also = [&] {
    if (warm) armWatch.cycle();
  };
  first.also = [&] {
    if (first.user.isWarm()) warm = true;
    if (warm) firstWatch.cycle();
  };
  second.also = [&] {
    if (warm) secondWatch.cycle();
  };
  suture::connectLocally(first.arm, arm.arm, "first");
  suture::connectLocally(second.arm, arm.arm, "second");
  arm.start();
  first.start();
  second.start();
  for (const Watch* watch : {&armWatch, &firstWatch, &secondWatch}) {
    EXPECT_TRUE(eventuallyDone(*watch));
  }
  first.stop();
  second.stop();
  arm.stop();
  for (const Watch* watch : {&armWatch, &firstWatch, &secondWatch}) {
    EXPECT_EQ(watch->findings(), Findings{});
  }
}

}  // namespace
}  // namespace proof
