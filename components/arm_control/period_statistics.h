#pragma once
// This measures how regularly cycles come.

#include <suture/base/time.h>

#include "robot_types/messages.h"

namespace robots {

/// Belongs to the thread that calls it. Measures the time between calls of cycle(), window by
/// window.
class PeriodStatistics {
 public:
  void cycle(suture::Time now);
  /// Returns the figures of the last whole window of 1 s; they are not valid before the first one
  /// has passed.
  const IntervalStatistics& last() const { return last_; }

 private:
  void close(suture::Time now);

  suture::Time begin_{}, previous_{};
  double sum_ = 0, squares_ = 0, min_ = 0, max_ = 0;
  std::uint32_t samples_ = 0;
  IntervalStatistics last_;
};

}  // namespace robots
