#pragma once
// This keeps a loop without Suture to its period.

#include <suture/base/time.h>

#include <cerrno>
#include <ctime>

namespace bench {

/// Puts the calling thread to sleep until `due`, with clock_nanosleep.
inline void sleepUntil(suture::Time due) {
  const auto count = suture::toNanoseconds(due);
  const timespec until{count / 1'000'000'000, count % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace bench
