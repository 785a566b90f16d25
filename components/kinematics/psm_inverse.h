#pragma once
// This is the inverse kinematics of the da Vinci patient side manipulator in closed form.

#include "kinematics/inverse.h"

namespace robots::kinematics {

/// Does what `inverse` does, for the chain that psm() makes, in bounded time: of the `postures`
/// within the limits that reach the goal it takes the one nearest to `start` (0.1 m of insertion
/// count as 1 rad); roll takes the turn nearest to it. Without limits there are four postures for
/// every pose: the wrist to either side of its yaw axis, and the shaft from either side of the
/// remote centre. So the goal is either found or limited. If it is limited, a bounded search
/// (nearest.h) finds the nearest point, and `iterations` counts its steps.
///
/// If the wrist stands in the remote centre, the shaft keeps the direction nearest to that of
/// `start`; if the wrist's yaw axis leads through the remote centre, the wrist pitch does. Both
/// mean within 1e-10 m. Beside those poses the exact answer may lie far from `start`, however near
/// the goal is.
///
/// A goal that is not finite is not found. Never allocates.
InverseSolution<6> psmInverse(const Chain<6>& chain, const Eigen::Isometry3d& goal,
                              const Chain<6>::Joints& start, Postures postures = Postures::All);

}  // namespace robots::kinematics
