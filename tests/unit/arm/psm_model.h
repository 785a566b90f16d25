#pragma once
// These tests move a PSM with an uneven parking place, whose quick joints keep them short.

#include "arm_control/arm_controller.h"
#include "kinematics/davinci.h"
#include "kinematics/psm_inverse.h"

namespace robots::test {

inline ArmModel<6> psmModel() {
  using Joints = ArmModel<6>::Joints;
  return {.chain = kinematics::psm(),
          .joint_names = {"a", "b", "c", "d", "e", "f"},
          .home = Joints::Constant(0.1),
          .rate_limit = Joints::Constant(4),
          .following_error = Joints::Constant(0.35),
          .inverse = kinematics::psmInverse};
}

inline ArmModel<6>::Joints psmParked() {
  ArmModel<6>::Joints parked = ArmModel<6>::Joints::Zero();
  parked[2] = 0.1;
  return parked;
}

}  // namespace robots::test
