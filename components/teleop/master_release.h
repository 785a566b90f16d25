#pragma once
// This lets a hand move a master whose motors would hold it.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <utility>

#include "arm/arm.suture.h"

namespace robots {

/// Belongs to the thread of the component that owns the required interface, which has it as a
/// member declared after that interface. It streams a wrench of zero, so the motors only carry the
/// arm, and a master whose client dies holds by itself; free() would leave it loose.
class MasterRelease {
 public:
  /// It does nothing unless `releases`: a master that gets goals from another client moves by
  /// those.
  MasterRelease(suture::Required<Arm>& master, bool releases)
      : master_(master), releases_(releases) {}

  /// Call this in each cycle in which a hand may move the master, with the stamp of the data by
  /// which that was decided.
  void release(suture::Time stamp) {
    if (!releases_) return;
    WrenchGoal none;
    none.stamp = stamp;
    isReleased_ = master_.body_servo_cf(none).has_value() || isReleased_;
  }
  /// Lets the master hold where it is, if this has released it.
  void end() {
    if (std::exchange(isReleased_, false)) (void)master_.hold();
  }

 private:
  suture::Required<Arm>& master_;
  const bool releases_;
  bool isReleased_ = false;
};

}  // namespace robots
