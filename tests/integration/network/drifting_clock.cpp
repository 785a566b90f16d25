// This stands in for the steady clock of a process: that of its machine, less 100 us in each second
// since DRIFT_FROM, ns. It is a slower clock, so that a sleep ends early, and what slept sleeps
// again.

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

std::int64_t beginning() {
  static const char* const kText = std::getenv("DRIFT_FROM");
  static const std::int64_t kBeginning = kText == nullptr ? 0 : std::atoll(kText);
  return kBeginning;
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const long result = syscall(SYS_clock_gettime, clock, time);
  if (result != 0 || clock != CLOCK_MONOTONIC) return static_cast<int>(result);
  const std::int64_t machines = time->tv_sec * kSecond + time->tv_nsec;
  const std::int64_t ours = machines - (machines - beginning()) / 10'000;
  *time = {.tv_sec = ours / kSecond, .tv_nsec = ours % kSecond};
  return 0;
}
