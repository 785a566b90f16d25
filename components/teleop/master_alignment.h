#pragma once
// How a master gets the orientation that its slave has, before that follows it.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <Eigen/Geometry>
#include <chrono>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"

namespace robots {

/// A member of the component that owns the required interface, declared after it and its watch;
/// belongs to the same thread.
class MasterAlignment {
 public:
  /// `tolerance`, rad: a difference so small counts as none.
  MasterAlignment(suture::Required<Arm>& master, const ArmWatch& watch, double tolerance)
      : master_(master), watch_(watch), tolerance_(tolerance) {}

  /// Once a cycle: true if the master rests at `pose` with the orientation `wanted`; else turns it
  /// to that about its tip. A master that somebody else moves, or that refuses, is asked again.
  bool align(const Eigen::Isometry3d& pose, const Eigen::Matrix3d& wanted, suture::Time now) {
    if (watch_.busy()) return false;
    if (Eigen::AngleAxisd(pose.linear().transpose() * wanted).angle() <= tolerance_) {
      moving_ = false;
      asked_ = {};
      return true;
    }
    if (now - asked_ < kPatience) return false;
    PoseStamped goal{pose, now, true};
    goal.pose.linear() = wanted;
    moving_ = master_.move_cp(goal).has_value();
    asked_ = now;
    return false;
  }

  /// The master is no longer to be turned: it stays where it is.
  void end() {
    if (moving_) (void)master_.hold();
    moving_ = false;
    asked_ = {};
  }

 private:
  static constexpr suture::Duration kPatience = std::chrono::seconds(1);

  suture::Required<Arm>& master_;
  const ArmWatch& watch_;
  const double tolerance_;
  bool moving_ = false;  // by this
  suture::Time asked_;
};

}  // namespace robots
