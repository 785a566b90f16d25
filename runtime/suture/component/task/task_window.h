#pragma once
// This measures how regularly a task ran and how long its cycles took, window by window.

#include <suture/base/time.h>
#include <suture/rt/histogram.h>
#include <suture/rt/snapshot.h>

#include <atomic>
#include <cstdint>

namespace suture {

/// Sums up the durations of one window. `p99` is the upper edge of a histogram's bucket, at most 6
/// % too large.
struct DurationSummary {
  Duration mean{}, deviation{}, min{}, max{}, p99{};
};

/// Measures one window of a task's cycles. It is a plain value, valid once `end` is set.
struct TaskWindow {
  Time begin{}, end{};        ///< when its first cycle began, and the first of the next window
  std::uint64_t cycles = 0;   ///< that began within
  std::uint64_t skipped = 0;  ///< periods or callbacks that passed without a cycle
  DurationSummary period;     ///< from the beginning of a cycle to that of the next
  DurationSummary compute;    ///< length of a cycle, without those of guests

  bool valid() const { return end != Time{}; }
};

/// Sums up durations. One thread; no allocation.
class DurationMeter {
 public:
  void add(Duration duration);
  /// Returns the summary of what was added since the last call.
  DurationSummary close();

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, squares_ = 0;  // ns; Welford's sums
  Duration min_{}, max_{};
  rt::Histogram histogram_;
};

/// Measures a task's windows in its own thread; any thread may read the last whole one. No
/// allocation, no locks.
class WindowMeter {
 public:
  /// Before the first cycle: sets the length of a window. Throws SetupError if that is not
  /// positive.
  void setLength(Duration length);

  /// Task's thread, at the end of each cycle. `skipped` is the count so far.
  void cycle(Time begin, Time end, std::uint64_t skipped);

  /// Task's thread, while no cycles come. Drops the window that has begun, because it would count
  /// the pause: the next cycle begins another.
  void interrupt();

  /// Any thread. Returns the last whole window.
  TaskWindow last() const { return last_.read(); }

 private:
  void close(Time end, std::uint64_t skipped);

  Duration length_ = std::chrono::seconds(1);
  Time begin_{}, previous_{};
  std::uint64_t cycles_ = 0, skippedBefore_ = 0;
  DurationMeter period_, compute_;
  rt::Snapshot<TaskWindow> last_;
};

}  // namespace suture
