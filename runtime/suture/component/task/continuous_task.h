#pragma once

#include <suture/component/task/thread_task.h>

namespace suture {

struct ContinuousOptions {
  rt::Scheduling scheduling{};
};

/// Runs one cycle after another without a pause, for a run() that itself waits, say for the next
/// frame of a camera. Give each such wait a deadline, because stop() waits for the cycle. On a
/// stepped clock each cycle takes at least kLeastCycle, because the task never sleeps. The task has
/// a thread of its own, in which run(), commands and handlers run.
class ContinuousTask : public ThreadTask {
 public:
  static constexpr Duration kLeastCycle = std::chrono::microseconds(100);

  explicit ContinuousTask(const ContinuousOptions& options = {}) : ThreadTask(options.scheduling) {}

 private:
  bool awaitCycle() final;
};

}  // namespace suture
