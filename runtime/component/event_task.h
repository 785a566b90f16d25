#pragma once

#include <suture/component/thread_task.h>

namespace suture {

struct EventOptions {
  rt::Scheduling scheduling{};
  /// The longest sleep: run() is called at least this often even if nothing arrives.
  Duration longestSleep = std::chrono::seconds(1);
};

/// Sleeps until a command or an event arrives, then runs one cycle.
class EventTask : public ThreadTask {
 public:
  explicit EventTask(const EventOptions& options = {})
      : ThreadTask(options.scheduling), longestSleep_(options.longestSleep) {}

 private:
  bool awaitCycle() final;

  Duration longestSleep_;
};

}  // namespace suture
