#pragma once
// This stands in for the drives of an arm that a test steps itself.

#include <chrono>
#include <optional>

#include "arm_control/arm_controller.h"
#include "drives/joint_dynamics.h"
#include "timing/seconds.h"

namespace robots::test {

/// Moves joints that trail the arm's set-points by 10 ms, and that brakes hold without power. Never
/// allocates.
template <int N>
class TrailingJoints {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  TrailingJoints(const ArmModel<N>& model, const Joints& parked)
      : dynamics_(0.01, model.rate_limit, model.chain.lower(), model.chain.upper(), parked) {}

  /// Runs one cycle of the arm at time `now`; its set-point acts on the joints from then on.
  void step(ArmController<N>& arm, suture::Time now) {
    if (last_ != suture::Time{} && !blocked_) dynamics_.advance(secondsBetween(last_, now));
    last_ = now;
    DriveReading<N> reading{dynamics_.measured() + displaced_, dynamics_.velocity(), power(arm),
                            permitted_, now + clockError_};
    reading.effort = drawn_;
    reading.measures_effort = measuresEffort_;
    reading.controls_effort = controlsEffort_;
    arm.step(now, reading);
    if (power(arm) == DrivePower::On) {
      dynamics_.command(arm.setpoint() - displaced_);
    } else {
      dynamics_.brake();
    }
  }
  /// Returns where the joints are, whatever their encoders say.
  const Joints& position() const { return dynamics_.measured(); }
  /// Makes the drives say so from now on, whatever the arm wants.
  void force(std::optional<DrivePower> power) { forced_ = power; }
  /// Puts its encoder off by so much from now on.
  void displace(int joint, double by) { displaced_[joint] = by; }
  /// Makes its motor give so much, N.m.
  void draw(int joint, double effort) { drawn_[joint] = effort; }
  void draw(const Joints& efforts) { drawn_ = efforts; }
  /// Leaves out from now on what the motors give.
  void measureNoEffort() { measuresEffort_ = false; }
  /// Says from now on that the drives obey efforts, which these joints do not.
  void controlEfforts() { controlsEffort_ = true; }
  /// Puts the arm's estimate of the drives' clock off by so much from now on.
  void misjudgeClock(suture::Duration by) { clockError_ = by; }
  /// Makes something hold the joints from now on.
  void block() { blocked_ = true; }
  /// Does as if they had stopped, and been permitted again, between two cycles of the arm.
  void permitAnew() { permitted_ += std::chrono::milliseconds(1); }

 private:
  DrivePower power(const ArmController<N>& arm) const {
    return forced_.value_or(arm.powered() ? DrivePower::On : DrivePower::Off);
  }

  JointDynamics<N> dynamics_;
  Joints displaced_ = Joints::Zero(), drawn_ = Joints::Zero();
  suture::Duration clockError_{0};
  suture::Time last_, permitted_ = suture::fromNanoseconds(1);
  std::optional<DrivePower> forced_;
  bool blocked_ = false, measuresEffort_ = true, controlsEffort_ = false;
};

}  // namespace robots::test
