// The watch reports what it is for: components that do what a task thread must not do, in the
// setting of steady_test.cpp.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/futex.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>
#include <suture/wiring/connect.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <ctime>
#include <functional>
#include <thread>

#include "rt/task_thread/arm_tasks.h"
#include "rt/task_thread/planted.h"
#include "rt/task_thread/watch.h"

namespace proof {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::uint64_t kWarmUp = 2'000, kCycles = 1'000;

/// A Case has the findings about an arm that does `crime` in every tenth of its cycles, and about
/// its client.
struct Case {
  std::vector<std::string> arm, client;
};

Case watched(const std::function<void()>& crime) {
  ArmTask<suture::ContinuousTask> arm;
  UserTask<suture::ContinuousTask> client;
  Watch armWatch("PSM", kWarmUp, kCycles), clientWatch("Console", kWarmUp, kCycles);
  std::atomic<bool> warm{false};
  arm.also = [&, cycle = 0]() mutable {
    if (!warm) return;
    armWatch.cycle();
    if (++cycle % 10 == 0) crime();
  };
  client.also = [&] {
    if (client.user.isWarm()) warm = true;
    if (warm) clientWatch.cycle();
  };
  suture::connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  while (!armWatch.done() || !clientWatch.done()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  client.stop();
  arm.stop();
  return {armWatch.findings(), clientWatch.findings()};
}

TEST(Watch, ReportsAnAllocation) {
  const Case found = watched(planted::allocateAndFree);
  EXPECT_THAT(found.arm, Contains(AllOf(StartsWith("PSM: malloc, 100 times in 1000 cycles"),
                                        HasSubstr("planted::allocateAndFree()"))));
  EXPECT_THAT(found.arm, Contains(StartsWith("PSM: free, 100 times in 1000 cycles")));
  EXPECT_THAT(found.client, IsEmpty());
}

TEST(Watch, ReportsALockAndItsWait) {
  planted::BusyLock lock;
  const Case found = watched([&] { lock.lockAndUnlock(); });
  EXPECT_THAT(found.arm,
              Contains(AllOf(StartsWith("PSM: pthread_mutex_lock, 100 times in 1000 cycles"),
                             HasSubstr("planted::BusyLock::lockAndUnlock()"))));
  EXPECT_THAT(found.arm, Contains(StartsWith("PSM: system call 202, ")));  // futex
  EXPECT_THAT(found.client, IsEmpty());
}

TEST(Watch, ReportsAPageFault) {
  planted::FreshMemory memory((kWarmUp + kCycles) / 10 + 1);
  const Case found = watched([&] { memory.touch(); });
  EXPECT_EQ(found.arm, std::vector<std::string>{"PSM: page fault, 100 times in 1000 cycles"});
  EXPECT_THAT(found.client, IsEmpty());
}

TEST(Watch, ReportsASystemCall) {
  const Case found = watched(planted::askTheKernel);
  ASSERT_EQ(found.arm.size(), 1u);
  EXPECT_THAT(found.arm[0], AllOf(StartsWith("PSM: system call 110, 100 times in 1000 cycles"),
                                  HasSubstr("planted::askTheKernel()")));
  EXPECT_THAT(found.client, IsEmpty());
}

// A task may sleep once in a cycle, and ring a sleeping peer once; the watch reports what is
// beyond.
TEST(Watch, ReportsASecondSleepOfACycle) {
  suture::rt::Doorbell bell;
  Watch watch("PSM", 2, 1, {.sleeps = 1, .wakes = 1});
  std::thread([&] {
    for (int cycle = 0; cycle < 3; ++cycle) {
      watch.cycle();
      for (int i = 0; i < 2; ++i) bell.waitUntil(suture::now() + std::chrono::milliseconds(1));
      for (int i = 0; i < 2; ++i) {
        bell.prepareToSleep();
        bell.ring();
        bell.takeRing();
      }
    }
  }).join();
  EXPECT_THAT(watch.findings(),
              testing::ElementsAre(AllOf(StartsWith("PSM: system call 202, 2 times in 1 cycles"),
                                         HasSubstr("suture::rt::Doorbell::waitUntil"))));
}

// A ring that came before the sleep allows one more sleep, so the second one more is reported.
TEST(Watch, ReportsAnUnexplainedSleep) {
  std::uint32_t word = 0;
  const auto sleepIf = [&word](std::uint32_t value) {
    const timespec briefly{.tv_sec = 0, .tv_nsec = 1'000'000};
    syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, value, &briefly, nullptr, 0);
  };
  Watch watch("PSM", 2, 1, {.sleeps = 1});
  std::thread([&] {
    for (int cycle = 0; cycle < 3; ++cycle) {
      watch.cycle();
      sleepIf(1);                              // rung already
      for (int i = 0; i < 2; ++i) sleepIf(0);  // the first is allowed, the second has no reason
    }
  }).join();
  EXPECT_THAT(watch.findings(),
              testing::ElementsAre(StartsWith("PSM: system call 202, 1 times in 1 cycles")));
}

}  // namespace
}  // namespace proof
