#pragma once

#include <suture/component/task/thread_task.h>

namespace suture {

struct EventOptions {
  rt::Scheduling scheduling{};
  /// The longest sleep: run() is called at least this often even if nothing arrives.
  Duration longestSleep = std::chrono::seconds(1);
};

/// Sleeps until a command, an event or an answer arrives, then runs one cycle. What a cycle has
/// taken itself, by within() or poll(), brings no other.
class EventTask : public ThreadTask {
 public:
  explicit EventTask(const EventOptions& options = {})
      : ThreadTask(options.scheduling), longestSleep_(options.longestSleep) {}

 private:
  bool awaitCycle() final;

  Duration longestSleep_;
};

}  // namespace suture
