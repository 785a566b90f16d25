#pragma once
// The kernel counts what processes have used; this reads it.

#include <sys/types.h>

#include <cstdint>

namespace peers {

/// Returns the user and system time of all threads of a process, in ns; 0 if there is none.
std::int64_t processorTime(pid_t process);

/// It counts for this process and another; the difference of two is what lies between them.
struct Usage {
  std::int64_t here = 0, there = 0;  ///< processor time in ns
  std::int64_t switches = 0;  ///< context switches of both processes' threads that still live
  std::int64_t loopbackBytes = 0, loopbackPackets = 0;

  static Usage with(pid_t other);
  Usage operator-(const Usage& earlier) const;
};

}  // namespace peers
