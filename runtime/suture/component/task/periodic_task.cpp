#include <suture/base/errors.h>
#include <suture/component/task/periodic_task.h>

#include <string>

namespace suture {

PeriodicTask::PeriodicTask(const PeriodicOptions& options)
    : ThreadTask(options.scheduling), period_(options.period) {
  if (options.period <= Duration{0}) {
    throw SetupError("a periodic task",
                     "a period of " + std::to_string(options.period.count()) + " ns",
                     "Give a period greater than zero");
  }
}

void PeriodicTask::beginCycles() { period_.begin(now()); }

bool PeriodicTask::awaitCycle() {
  const Time due = period_.advance(now());
  mutableActivity().sleep(due);
  while (!ending() && now() < due) stopBell().waitUntil(due);
  mutableStatistics().lateness.record(now() - due);
  mutableStatistics().skipped.store(period_.skipped(), std::memory_order_relaxed);
  return !ending();
}

}  // namespace suture
