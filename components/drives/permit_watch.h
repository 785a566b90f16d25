#pragma once
// Whether drives may have power.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include "coordinator/emergency_stop.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

/// Follows the emergency stop behind one required interface. A member of the component that owns
/// that interface, declared after it; belongs to the same thread.
class PermitWatch {
 public:
  /// A permit counts for `maxAge`; 0: power needs none.
  PermitWatch(suture::Required<EmergencyStop>& stop, suture::Duration maxAge)
      : stop_(stop), maxAge_(maxAge) {
    stop_.on().stop([this](const StopNews& news) { pressed_ = news.pressed; });
  }
  PermitWatch(const PermitWatch&) = delete;
  PermitWatch& operator=(const PermitWatch&) = delete;

  /// Once a cycle, after its events. The event is heard before the permit says so, or after it.
  /// Drives that stood still themselves for longer than a permit counts have done without one.
  bool granted() {
    if (maxAge_ == suture::Duration{0}) return true;
    const bool looked = !cycles_.missed(maxAge_);
    const auto permit = stop_.permit();
    return looked && !pressed_ && permit && permit->granted &&
           suture::now() - permit->stamp <= maxAge_;
  }

 private:
  suture::Required<EmergencyStop>& stop_;
  const suture::Duration maxAge_;
  CycleWatch cycles_;
  bool pressed_ = false;
};

}  // namespace robots
