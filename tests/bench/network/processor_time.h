#pragma once
// This tells what a process has used of the processors.

#include <sys/types.h>

#include <ctime>

namespace bench {

/// Returns what all threads of process `pid` have had until now, s; 0 if it is gone.
inline double processorTime(pid_t pid) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace bench
