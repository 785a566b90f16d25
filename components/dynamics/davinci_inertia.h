#pragma once
// These numbers say what the da Vinci arms weigh, how much friction they have, what their motors
// can do and what their encoders measure. They are for simulation only, never for clinical use.
// README.md says which are published, and which are our own estimate.

#include "dynamics/arm_dynamics.h"

namespace robots::dynamics {

/// Joint vectors are in the units of the joints: N.m or N per rad/s or m/s, and so on.
template <int N>
struct ArmMechanics {
  using Joints = typename ArmDynamics<N>::Joints;

  typename ArmDynamics<N>::Links links;
  Joints viscous;       ///< effort per unit of velocity
  Joints coulomb;       ///< effort: what friction takes at any velocity, and at most at rest
  Joints effort_limit;  ///< the most that motors give the joint
  /// Motors and encoders belong to actuators, which are coupled with the joints if the arm's drives
  /// say so (drives/coupling.h).
  Joints motor_limit;   ///< the most that each motor gives
  Joints encoder_step;  ///< how far the actuator moves in one count of its encoder
};

/// Returns the mechanics with the large needle driver, for kinematics::psm().
ArmMechanics<6> psmMechanics();

/// Returns the mechanics for kinematics::mtmLeft() and mtmRight() alike.
ArmMechanics<7> mtmMechanics();

}  // namespace robots::dynamics
