#pragma once
// Absolute deadlines of a periodic task.

#include <suture/base/time.h>

#include <cstdint>

namespace suture::rt {

/// The grid of due times of one periodic task. Its own thread only. A due time that has passed is
/// skipped and counted, so executed + skipped = elapsed / period, within one.
class Period {
 public:
  explicit Period(Duration length) : length_(length) {}

  /// Fixes the grid: the first due time is one period after `start`.
  void begin(Time start) { due_ = start; }

  /// The next due time after `time`.
  Time advance(Time time) {
    due_ += length_;
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
