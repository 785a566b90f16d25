#pragma once
// How regularly cycles come.

#include <suture/base/time.h>

#include "robot_types/messages.h"

namespace robots {

/// Measures the time between calls of cycle(), window by window. Belongs to the thread that calls
/// it.
class PeriodStatistics {
 public:
  void cycle(suture::Time now);
  /// The figures of the last whole window of 1 s; not valid before the first one has passed.
  const IntervalStatistics& last() const { return last_; }

 private:
  void close(suture::Time now);

  suture::Time begin_{}, previous_{};
  double sum_ = 0, squares_ = 0, min_ = 0, max_ = 0;
  std::uint32_t samples_ = 0;
  IntervalStatistics last_;
};

}  // namespace robots
