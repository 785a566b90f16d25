#pragma once
// The gripper of a simulated master, which a hand holds and nothing drives.

#include <cmath>

#include "drives/gripper_hand.h"
#include "drives/joint_dynamics.h"
#include "kinematics/davinci.h"

namespace robots {

/// Its springs hold it open until the hand presses it. Power and brakes mean nothing to it.
/// Confined to one thread; only the constructor allocates or throws.
class HeldGripper final : public SimulatedJoints<1>, public GripperHand {
 public:
  /// `lag` in s, > 0: how long it takes to follow the fingers.
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
