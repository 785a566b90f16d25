#pragma once
// This computes the absolute deadlines of a periodic task.

#include <suture/base/time.h>

#include <cstdint>

namespace suture::rt {

/// The task's own thread only. Keeps the grid of due times of one periodic task. A due time that
/// has passed is skipped and counted, so executed + skipped = elapsed / period, within one.
class Period {
 public:
  explicit Period(Duration length) : length_(length) {}

  /// Fixes the grid. The first due time is one period after `start`.
  void begin(Time start) { due_ = start; }

  /// Returns the next due time after `time`.
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
