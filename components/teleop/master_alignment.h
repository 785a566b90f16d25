#pragma once
// This turns a master to the orientation of its slave, before the slave follows it.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <Eigen/Geometry>
#include <chrono>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"

namespace robots {

/// Belongs to the thread of the component that owns the required interface, which has it as a
/// member declared after that interface and its watch.
class MasterAlignment {
 public:
  /// A difference of at most `tolerance`, in rad, counts as none.
  MasterAlignment(suture::Required<Arm>& master, const ArmWatch& watch, double tolerance)
      : master_(master), watch_(watch), tolerance_(tolerance) {}

  /// Call this once a cycle. Returns true if the master rests at `pose` with the orientation
  /// `wanted`; otherwise turns it to that about its tip. A master that somebody else moves, or that
  /// refuses, is asked again.
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

  /// Ends turning the master: it stays where it is.
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
  bool moving_ = false;  // by this object
  suture::Time asked_;
};

}  // namespace robots
