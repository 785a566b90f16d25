#pragma once
// These tests move a PSM with an uneven parking place, whose quick joints keep them short.

#include "arm/kinematics/davinci.h"
#include "arm/simulated_arm.h"

namespace robots::test {

inline ArmModel<6> psmModel() {
  using Joints = ArmModel<6>::Joints;
  ArmModel<6> model{.chain = kinematics::psm(),
                    .joint_names = {"a", "b", "c", "d", "e", "f"},
                    .parked = Joints::Zero(),
                    .home = Joints::Constant(0.1),
                    .rate_limit = Joints::Constant(4),
                    .time_constant = 0.01,
                    .following_error = Joints::Constant(0.35)};
  model.parked[2] = 0.1;
  return model;
}

}  // namespace robots::test
