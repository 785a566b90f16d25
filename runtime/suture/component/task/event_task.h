#pragma once

#include <suture/component/task/thread_task.h>

#include <optional>

namespace suture {

struct EventOptions {
  rt::Scheduling scheduling{};
  /// Calls run() at least this often, even if nothing arrives. Without it, a task for which nothing
  /// arrives sleeps on; while a client on the `shm` lane may ring, it looks again once a second.
  std::optional<Duration> longestSleep{};
};

/// Sleeps until a command, an event or an answer arrives, then runs one cycle. What a cycle has
/// taken itself, by within() or poll(), starts no other cycle. The task has a thread of its own, in
/// which run(), commands and handlers run.
class EventTask : public ThreadTask {
 public:
  /// Throws SetupError if the longest sleep is not positive.
  explicit EventTask(const EventOptions& options = {});

 private:
  bool awaitCycle() final;

  const std::optional<Duration> longestSleep_;
};

}  // namespace suture
