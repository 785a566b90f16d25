#pragma once
// How a task's thread is scheduled.

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

/// Applies the name (at most 15 characters are kept) and the scheduling to the calling thread.
/// Throws SetupError if the kernel refuses, e.g. without the right to real-time priorities.
void configureThisThread(const std::string& name, const Scheduling& scheduling);

}  // namespace suture::rt
