#pragma once
// These are the drives of the da Vinci arms as rigid bodies and controllers.

#include "drives/drive_dynamics.h"
#include "drives/rigid_body_joints.h"

namespace robots {

/// Returns the model of a patient side manipulator. `parked` and `rateLimit` are in rad and m, and
/// per second.
RigidBodyModel<6> psmRigidBody(const RigidBodyModel<6>::Joints& parked,
                               const RigidBodyModel<6>::Joints& rateLimit,
                               const RigidBodyOptions& options = {});

/// Returns the model of a master tool manipulator; `chain` is kinematics::mtmLeft() or mtmRight().
RigidBodyModel<7> mtmRigidBody(const kinematics::Chain<7>& chain,
                               const RigidBodyModel<7>::Joints& parked,
                               const RigidBodyModel<7>::Joints& rateLimit,
                               const RigidBodyOptions& options = {});

}  // namespace robots
