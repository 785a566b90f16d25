#pragma once
// This computes the absolute deadlines of a periodic task.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace suture::rt {

/// Returns `period`. Throws SetupError if it is not positive, since `whose` loop would never sleep.
inline Duration positivePeriod(std::string_view whose, Duration period) {
  if (period > Duration{0}) return period;
  throw SetupError(whose, "a period of " + std::to_string(period.count()) + " ns",
                   "Give a period greater than zero");
}

/// The task's own thread only. Keeps the grid of due times of one periodic task. A due time that
/// has passed is skipped and counted, so executed + skipped = elapsed / period, within one.
class Period {
 public:
  explicit Period(Duration length) : length_(length) {}

  /// Fixes the grid. The first due time is one period after `start`.
  void begin(Time start) { due_ = start; }

  /// Returns the next due time after `time`.
  Time advance(Time time) {
    due_ += std::min(length_, Time::max() - due_);  // no overflow by a period without end
    if (due_ <= time) {
      const auto missed = (time - due_) / length_ + 1;
      skipped_ += static_cast<std::uint64_t>(missed);
      due_ += missed * length_;
    }
    return due_;
  }

  Duration length() const { return length_; }
  std::uint64_t skipped() const { return skipped_; }

 private:
  Duration length_;
  Time due_{};
  std::uint64_t skipped_ = 0;
};

}  // namespace suture::rt
