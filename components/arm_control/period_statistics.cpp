#include "arm_control/period_statistics.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "timing/seconds.h"

namespace robots {

void PeriodStatistics::cycle(suture::Time now) {
  if (previous_ == suture::Time{}) begin_ = previous_ = now;
  if (now == previous_) return;
  const double period = secondsBetween(previous_, now);
  previous_ = now;
  min_ = samples_ == 0 ? period : std::min(min_, period);
  max_ = samples_ == 0 ? period : std::max(max_, period);
  sum_ += period;
  squares_ += period * period;
  ++samples_;
  if (now - begin_ >= std::chrono::seconds(1)) close(now);
}

void PeriodStatistics::close(suture::Time now) {
  const double average = sum_ / samples_;
  last_ = {.period_average = average,
           .period_deviation = std::sqrt(std::max(0.0, squares_ / samples_ - average * average)),
           .period_min = min_,
           .period_max = max_,
           .samples = samples_,
           .stamp = now,
           .valid = true};
  begin_ = now;
  sum_ = squares_ = 0;
  samples_ = 0;
}

}  // namespace robots
