#pragma once
// This tells drives if they may have power.

#include <suture/base/sample.h>
#include <suture/base/time.h>
#include <suture/component/required.h>

#include <chrono>
#include <utility>

#include "coordinator/emergency_stop.suture.h"
#include "parameters/valid_time.h"
#include "timing/cycle_watch.h"

namespace robots {

/// Belongs to the thread of the component that owns the required interface, which has it as a
/// member declared after that interface. Follows the emergency stop behind it.
class PermitWatch {
 public:
  /// A permit counts for `maxAge`; with 0, power needs none, and only a stop that is pressed takes
  /// it. Throws suture::SetupError unless it is that or from 1 ms to 1 s.
  PermitWatch(suture::Required<EmergencyStop>& stop, suture::Duration maxAge)
      : stop_(stop), maxAge_(maxAge) {
    requireTimeOrZero("permit", maxAge, {.longest = std::chrono::seconds(1)});
    stop_.on().stop([this](const StopNews& news) {
      pressed_ = news.pressed;
      wasPressed_ = wasPressed_ || news.pressed;
    });
  }
  PermitWatch(const PermitWatch&) = delete;
  PermitWatch& operator=(const PermitWatch&) = delete;

  /// Call this once a cycle, after the events. Returns true if the drives may have power. The event
  /// and the permit are each enough to stop, whichever comes first. Drives that stood still
  /// themselves for longer than a permit counts were without one meanwhile.
  bool granted() {
    const bool pressed = std::exchange(wasPressed_, pressed_);
    if (maxAge_ == suture::Duration{0}) return !pressed;
    const bool looked = !cycles_.missed(maxAge_);
    return looked && !pressed && isFresh(stop_.permit());
  }

 private:
  // A permit from the future counts as little as an old one.
  bool isFresh(const suture::Sample<Permit>& permit) const {
    if (!permit || !permit->granted || permit.age() > maxAge_) return false;
    const suture::Duration age = suture::now() - permit->stamp;
    return age <= maxAge_ && age >= -maxAge_;
  }

  suture::Required<EmergencyStop>& stop_;
  const suture::Duration maxAge_;
  CycleWatch cycles_;
  bool pressed_ = false;
  bool wasPressed_ = false;  // since the last look
};

}  // namespace robots
