// No test can suspend the machine, so this one looks at which of the kernel's clocks is read.

#include <gtest/gtest.h>
#include <suture/base/boot_time.h>

#include <ctime>

namespace {

constexpr std::time_t kAsleep = 3600;  // s

}  // namespace

extern "C" {

int __real_clock_gettime(clockid_t clock, timespec* time);

// The linker puts this in the place of the kernel's clocks, on a machine that has slept.
int __wrap_clock_gettime(clockid_t clock, timespec* time) {
  const int result = __real_clock_gettime(clock, time);
  if (clock == CLOCK_BOOTTIME) time->tv_sec += kAsleep;
  return result;
}

}  // extern "C"

namespace suture {
namespace {

TEST(BootClock, GoesOnWhileTheMachineIsSuspended) {
  timespec awake{};
  __real_clock_gettime(CLOCK_BOOTTIME, &awake);
  EXPECT_GE(BootClock::now().time_since_epoch(), std::chrono::seconds(awake.tv_sec + kAsleep));
}

}  // namespace
}  // namespace suture
