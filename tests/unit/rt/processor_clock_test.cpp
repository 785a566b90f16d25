#include <gtest/gtest.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/processor_clock.h>

#include <chrono>
#include <thread>

#include "support/patience.h"

namespace suture::rt {
namespace {

using namespace std::chrono_literals;

/// Makes the calling thread work until it has had so much processor time.
void workFor(Duration share) {
  timespec time{};
  do clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  while (std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec) < share);
}

TEST(ProcessorClock, KeepsTheCountOfEndedThreads) {
  ProcessorClock clock;
  EXPECT_EQ(clock.used(), 0ns);
  Doorbell worked, seen;
  const auto body = [&] {
    clock.begin();
    workFor(5ms);
    worked.ring();
    seen.waitUntil(now() + kPatience);
    clock.end();
  };
  Duration before{};
  for (int turn = 0; turn < 2; ++turn) {
    std::thread thread(body);
    worked.waitUntil(now() + kPatience);
    const Duration running = clock.used();
    EXPECT_GE(running, before + 5ms);
    seen.ring();
    thread.join();
    before = clock.used();
    EXPECT_GE(before, running);
  }
  EXPECT_EQ(clock.used(), before) << "nobody runs";
}

TEST(ProcessorClock, OtherThreadsDoNotCount) {
  ProcessorClock clock;
  Doorbell begun, seen;
  std::thread thread([&] {
    clock.begin();
    begun.ring();
    seen.waitUntil(now() + kPatience);
    clock.end();
  });
  begun.waitUntil(now() + kPatience);
  const Duration process = processorTimeOfProcess();
  std::thread([] { workFor(50ms); }).join();
  EXPECT_LT(clock.used(), 50ms);
  EXPECT_GE(processorTimeOfProcess(), process + 50ms);
  seen.ring();
  thread.join();
}

}  // namespace
}  // namespace suture::rt
