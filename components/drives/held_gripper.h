#pragma once
// This is the gripper of a simulated master, which a hand holds and nothing drives.

#include <cmath>

#include "drives/gripper_hand.h"
#include "drives/joint_dynamics.h"
#include "kinematics/davinci.h"

namespace robots {

/// One thread; only the constructor allocates or throws. Springs hold the gripper open until the
/// hand presses it. Power and brakes have no effect on it.
class HeldGripper final : public SimulatedJoints<1>, public GripperHand {
 public:
  /// `lag` is how long it takes to follow the fingers, in s, > 0.
  explicit HeldGripper(double lag)
      : joint_(lag, Joints(kQuickest), Joints(kRange.lower), Joints(kRange.upper),
               Joints(kRange.upper)) {}

  void squeeze(double angle) override {
    if (std::isfinite(angle)) joint_.command(Joints(angle));
  }

  void advance(double dt) override { joint_.advance(dt); }
  void command(const Joints& /*setpoint*/) override {}
  void brake() override {}
  const Joints& measured() const override { return joint_.measured(); }
  Joints velocity() const override { return joint_.velocity(); }

 private:
  static constexpr kinematics::AngleRange kRange = kinematics::kMtmGripper;
  static constexpr double kQuickest = 20;  // rad/s, of fingers: an estimate of our own

  JointDynamics<1> joint_;
};

}  // namespace robots
