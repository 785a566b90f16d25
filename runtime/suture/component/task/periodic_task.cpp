#include <suture/component/task/periodic_task.h>

namespace suture {

PeriodicTask::PeriodicTask(const PeriodicOptions& options)
    : ThreadTask(options.scheduling),
      period_(rt::positivePeriod("a periodic task", options.period)) {}

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
