#pragma once

#include <suture/component/task/thread_task.h>
#include <suture/rt/period.h>

namespace suture {

struct PeriodicOptions {
  Duration period = std::chrono::milliseconds(1);
  rt::Scheduling scheduling{};
};

/// Runs a cycle at absolute due times, one period apart. A due time that passes while a cycle runs
/// is skipped and counted: executed + skipped = elapsed / period, within one. The task has a thread
/// of its own, in which run(), commands and handlers run; docs/howto/tasks.md says who may call
/// what.
class PeriodicTask : public ThreadTask {
 public:
  /// Throws SetupError if the period is not positive.
  explicit PeriodicTask(const PeriodicOptions& options);

  /// Any thread. Returns the period, which is the same as long as the task lives.
  Duration period() const { return period_.length(); }

 private:
  void beginCycles() final;
  bool awaitCycle() final;

  rt::Period period_;
};

}  // namespace suture
