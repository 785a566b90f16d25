#pragma once
// These are the da Vinci arms as the drives simulate them with mass, for tests.

#include "drives/davinci_joints.h"
#include "kinematics/davinci.h"

namespace robots::test {

constexpr double kDriveCycle = 1.0 / 1500;  // s

inline RigidBodyModel<6> heavyPsm(const RigidBodyOptions& options = {}) {
  using Joints = RigidBodyModel<6>::Joints;
  constexpr int kInsertion = 2;
  Joints rates = Joints::Constant(4);
  rates[kInsertion] = 0.4;
  return psmRigidBody(Joints::Unit(kInsertion) * 0.1, rates, options);
}

inline RigidBodyModel<7> heavyMtm(const RigidBodyOptions& options = {}) {
  return mtmRigidBody(kinematics::mtmLeft(), kinematics::mtmHome(),
                      RigidBodyModel<7>::Joints::Constant(4), options);
}

/// It has power, and no controller.
template <int N>
RigidBodyModel<N> released(RigidBodyModel<N> model) {
  model.stiffness.setZero();
  model.damping.setZero();
  return model;
}

}  // namespace robots::test
