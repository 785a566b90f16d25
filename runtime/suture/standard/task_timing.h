#pragma once
// This says how regularly a task runs.

#include <suture/annotate.h>
#include <suture/component/task/task_window.h>

#include <cstdint>

namespace suture {

SUTURE_EXTERNAL_TYPE(DurationSummary, mean, deviation, min, max, p99);
SUTURE_EXTERNAL_TYPE(TaskWindow, begin, end, cycles, skipped, period, compute);

/// Any task may provide this: `suture::TimingPort timing_{*this};`.
class SUTURE_INTERFACE() TaskTiming {
 public:
  virtual ~TaskTiming() = default;
  /// Returns the last whole window, of 1 s unless the task says otherwise; `end` is unset before
  /// the first.
  SUTURE_COMMAND() virtual TaskWindow window() const = 0;
  /// Counts the cycles since the task exists.
  SUTURE_COMMAND() virtual std::uint64_t cycles() const = 0;
  /// Counts the periods or callbacks that passed without a cycle, since the task exists.
  SUTURE_COMMAND() virtual std::uint64_t skipped() const = 0;
};

}  // namespace suture
