#pragma once
// This is the inverse kinematics of the da Vinci master tool manipulators in closed form.

#include <optional>

#include "kinematics/inverse.h"

namespace robots::kinematics {

/// Does what `inverse` does, for the chains that mtmLeft() and mtmRight() make, in bounded time.
/// Joints 4 to 7 meet in one point, so that yaw, shoulder and elbow follow from where that is. The
/// other four joints set the three degrees of orientation, so that one of them, the platform, is
/// free. It gets its angle in two steps. Of the ranges that leave the wrist within its limits, the
/// nearest to the platform in `start` is taken. In that range at most eight steps of closed form go
/// downhill to the angle at which joints 4 to 7 come nearest to those of `start`. So joints that
/// need not move stay near. Roll takes the turn nearest to `start`.
///
/// A goal is out of reach if the arm is too short or too long for it, else found or limited. If it
/// is not found, a bounded search (nearest.h) finds the nearest point, and `iterations` counts its
/// steps. If the wrist stands on the outer yaw's axis, within 1e-10 m, that joint keeps its angle;
/// beside the axis the exact answer may lie far from `start`.
///
/// A goal that is not finite is not found. Never allocates.
InverseSolution<7> mtmInverse(const Chain<7>& chain, const Eigen::Isometry3d& goal,
                              const Chain<7>::Joints& start, Postures postures = Postures::All);

/// Returns the joints that reach `goal` with the platform at this angle. Of the postures of yaw,
/// shoulder and elbow it takes the one within their limits, or else the nearest to `start`. The
/// joints may lie beyond the limits (see clamp() and within() of the chain). Returns nothing if the
/// goal is out of reach or not finite. Never allocates.
std::optional<Chain<7>::Joints> mtmAtPlatform(const Chain<7>& chain, const Eigen::Isometry3d& goal,
                                              double platform, const Chain<7>::Joints& start);

}  // namespace robots::kinematics
