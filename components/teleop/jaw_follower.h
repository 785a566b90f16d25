#pragma once
// This is the jaw's part of a teleoperation.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <algorithm>
#include <optional>

#include "arm/gripper.suture.h"
#include "arm/jaw.suture.h"
#include "teleop/jaw_law.h"
#include "timing/recent.h"
#include "timing/seconds.h"

namespace robots {

/// Belongs to the thread of the component that owns both interfaces, which has it as a member
/// declared after them. Does nothing in a deployment that does not connect both.
class JawFollower {
 public:
  /// While the data of the gripper or of the jaw are older than `maxAge`, the jaw stays where it
  /// is. Following begins anew with fresh ones.
  JawFollower(suture::Required<Gripper>& gripper, suture::Required<Jaw>& jaw,
              const JawSettings& settings, suture::Duration maxAge)
      : gripper_(gripper), jaw_(jaw), settings_(settings), maxAge_(maxAge) {
    goal_.position.resize(1);
  }

  /// Call this once in each cycle in which the slave follows.
  void follow(suture::Time now) {
    const auto gripper = gripper_.measured_js(gripperState_);
    const auto jaw = jaw_.setpoint_js(jawState_);
    if (!isFresh(gripper, gripperState_) || !isFresh(jaw, jawState_)) return end();
    if (!law_) law_.emplace(settings_, jawState_.position.front());
    const double seconds = inSeconds(std::min(now - last_.value_or(now), maxAge_));
    last_ = now;
    goal_.position.front() = law_->follow(gripperState_.position.front(), seconds);
    goal_.stamp = gripperState_.stamp;
    if (!jaw_.servo_jp(goal_)) end();
  }

  /// Ends following: the jaw stays where it is.
  void end() {
    law_.reset();
    last_.reset();
  }

 private:
  bool isFresh(const suture::Sample<void>& sample, const JointState& state) const {
    return sample && sample.age() <= maxAge_ && state.valid && state.position.size() == 1 &&
           isRecent(state.stamp, maxAge_);
  }

  suture::Required<Gripper>& gripper_;
  suture::Required<Jaw>& jaw_;
  const JawSettings settings_;
  const suture::Duration maxAge_;
  JointState gripperState_, jawState_;  // members, so that reads allocate nothing
  JointGoal goal_;
  std::optional<JawLaw> law_;
  std::optional<suture::Time> last_;  // the last cycle in which it followed
};

}  // namespace robots
