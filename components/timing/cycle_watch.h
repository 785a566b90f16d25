#pragma once

#include <suture/base/boot_time.h>
#include <suture/base/time.h>

#include <utility>

namespace robots {

/// Belongs to the task's thread. Tells if its cycles follow each other. A task that was frozen or
/// suspended has not seen what its arms did meanwhile, although their data are fresh when it looks
/// again, so it must not go on as if nothing had happened. Neither must one whose machine slept, so
/// the time is of the clock that goes on then.
class CycleWatch {
 public:
  /// Says that the cycles begin now, so that the first is not late.
  void begin() { last_ = suture::BootClock::now(); }
  /// Returns how long ago the last cycle was; a long time if none has begun.
  suture::Duration sinceLast() const { return suture::BootClock::now() - last_; }
  /// Call this once a cycle. Returns true if the last cycle was longer ago than `most`, or none
  /// has begun.
  bool missed(suture::Duration most) {
    const suture::BootTime now = suture::BootClock::now();
    return now - std::exchange(last_, now) > most;
  }

 private:
  suture::BootTime last_;
};

}  // namespace robots
