#pragma once
// How a task's thread is scheduled.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <thread>

namespace suture::rt {

struct Scheduling {
  /// 1..99: SCHED_FIFO; absent: the default policy.
  std::optional<int> fifoPriority = std::nullopt;
  /// Pins the thread to this processor.
  std::optional<int> cpu = std::nullopt;
};

/// The slice of a task under the default policy, and that of a thread that serves tasks. A thread
/// that wakes up takes the processor from one of a longer slice: so a task runs as soon as there is
/// something to do, and has answered before the thread that woke it goes to sleep.
inline constexpr Duration kTaskSlice = std::chrono::microseconds(100);
inline constexpr Duration kServiceSlice = std::chrono::milliseconds(1);

/// Asks the kernel to let the calling thread run for `slice` at a time, if it is under the default
/// policy. Linux before 6.12 does not know such a wish; then nothing changes.
void askForSlice(Duration slice);

/// Applies the name (at most 15 characters are kept) and the scheduling to the calling thread, and
/// has its timed sleeps end when they are due.
/// Throws SetupError if the kernel refuses, e.g. without the right to real-time priorities.
void configureThisThread(const std::string& name, const Scheduling& scheduling);

}  // namespace suture::rt
