#include <suture/base/errors.h>
#include <suture/component/task/task_window.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace suture {
namespace {

Duration rounded(double nanoseconds) { return Duration(std::llround(nanoseconds)); }

}  // namespace

void DurationMeter::add(Duration duration) {
  min_ = count_ == 0 ? duration : std::min(min_, duration);
  max_ = count_ == 0 ? duration : std::max(max_, duration);
  ++count_;
  const auto value = static_cast<double>(duration.count());
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
  histogram_.record(duration);
}

DurationSummary DurationMeter::close() {
  DurationSummary summary;
  if (count_ > 0) {
    const double variance = squares_ / static_cast<double>(count_);
    summary = {.mean = rounded(mean_),
               .deviation = rounded(std::sqrt(variance)),
               .min = min_,
               .max = max_,
               .p99 = histogram_.quantile(0.99)};
  }
  count_ = 0;
  mean_ = squares_ = 0;
  histogram_.clear();
  return summary;
}

void WindowMeter::setLength(Duration length) {
  if (length <= Duration{0}) {
    throw SetupError("a window of a task's statistics",
                     "a length of " + std::to_string(length.count()) + " ns",
                     "Give a length greater than zero");
  }
  length_ = length;
}

void WindowMeter::cycle(Time begin, Time end, std::uint64_t skipped) {
  if (begin_ == Time{}) {
    begin_ = begin;
    skippedBefore_ = skipped;
  } else {
    period_.add(begin - previous_);
    if (begin - begin_ >= length_) close(begin, skipped);
  }
  previous_ = begin;
  ++cycles_;
  compute_.add(end - begin);
}

void WindowMeter::interrupt() {
  if (begin_ == Time{}) return;
  begin_ = Time{};
  cycles_ = 0;
  period_.close();
  compute_.close();
}

void WindowMeter::close(Time end, std::uint64_t skipped) {
  last_.write({.begin = begin_,
               .end = end,
               .cycles = cycles_,
               .skipped = skipped - skippedBefore_,
               .period = period_.close(),
               .compute = compute_.close()});
  begin_ = end;
  cycles_ = 0;
  skippedBefore_ = skipped;
}

}  // namespace suture
