#pragma once
// What the da Vinci arms weigh, how they rub, what their motors can do and what their encoders see.
// For simulation only, never for clinical use. README.md tells what is published, and what is our
// own estimate.

#include "dynamics/arm_dynamics.h"

namespace robots::dynamics {

/// Joint vectors are in the units of the joints: N.m or N per rad/s or m/s, and so on.
template <int N>
struct ArmMechanics {
  using Joints = typename ArmDynamics<N>::Joints;

  typename ArmDynamics<N>::Links links;
  Joints viscous;       ///< effort per unit of velocity
  Joints coulomb;       ///< effort: what friction takes whatever the velocity, and at rest at most
  Joints effort_limit;  ///< the most that motors give the joint
  /// Motors and encoders are of actuators, which are coupled with the joints where the arm's drives
  /// say so (drives/coupling.h).
  Joints motor_limit;   ///< the most that each motor gives
  Joints encoder_step;  ///< what one count of each encoder is of its actuator
};

/// With the large needle driver, for kinematics::psm().
ArmMechanics<6> psmMechanics();

/// For kinematics::mtmLeft() and mtmRight() alike.
ArmMechanics<7> mtmMechanics();

}  // namespace robots::dynamics
