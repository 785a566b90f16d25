#include <pthread.h>
#include <suture/rt/processor_clock.h>

#include <chrono>

namespace suture::rt {
namespace {

/// Returns zero if the clock's thread has ended.
Duration readingOf(clockid_t clock) {
  timespec time{};
  if (clock_gettime(clock, &time) != 0) return Duration{0};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

Duration processorTimeOfProcess() { return readingOf(CLOCK_PROCESS_CPUTIME_ID); }

void ProcessorClock::begin() {
  clockid_t clock{};
  if (pthread_getcpuclockid(pthread_self(), &clock) == 0) {
    clock_.store(clock, std::memory_order_release);
  }
}

void ProcessorClock::end() {
  before_.fetch_add(readingOf(CLOCK_THREAD_CPUTIME_ID).count(), std::memory_order_relaxed);
  clock_.store(std::nullopt, std::memory_order_release);
}

// A thread that ends during the call may be counted twice, or not at all, in this one answer.
Duration ProcessorClock::used() const {
  const auto clock = clock_.load(std::memory_order_acquire);
  const Duration before(before_.load(std::memory_order_relaxed));
  return clock ? before + readingOf(*clock) : before;
}

}  // namespace suture::rt
