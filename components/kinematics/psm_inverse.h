#pragma once
// Inverse kinematics of the da Vinci patient side manipulator in closed form.

#include "kinematics/inverse.h"

namespace robots::kinematics {

/// As `inverse` does, for the chain that psm() makes, in bounded time: of the `postures` within the
/// limits that reach the goal the one nearest to `start` (0.1 m of insertion count as 1 rad); roll
/// takes the turn nearest to it. Without limits there are four postures for every pose: the wrist
/// to either side of its yaw axis, and the shaft from either side of the remote centre. So the goal
/// is found, or limited. Then a bounded search (nearest.h) finds the nearest point, and
/// `iterations` counts its steps.
///
/// Where the wrist stands in the remote centre, the shaft keeps the direction nearest to that of
/// `start`; where the wrist's yaw axis leads through it, the wrist pitch does. "Where" means within
/// 1e-10 m. Beside those poses the exact answer may lie far from `start`, however near the goal is.
///
/// A goal that is not finite is not found. Never allocates.
InverseSolution<6> psmInverse(const Chain<6>& chain, const Eigen::Isometry3d& goal,
                              const Chain<6>::Joints& start, Postures postures = Postures::All);

}  // namespace robots::kinematics
