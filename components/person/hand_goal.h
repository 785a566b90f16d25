#pragma once
// This says where a velocity leads the goal of an arm.

#include <Eigen/Geometry>

#include "person/hand_input.h"

namespace robots {

/// The goal of a person's hand runs ahead of the set-point of its arm by at most these, in m and
/// rad. The lag of an arm is shorter: 20 ms at 0.25 m/s are 5 mm. Beyond it the arm is at a limit,
/// and a goal that ran on would have to come all the way back before the arm moves again.
inline constexpr double kFurthestLead = 0.02, kWidestLead = 0.2;

/// Any thread; never allocates. Returns `goal` after `dt` seconds of `input`, no farther from
/// `setpoint` than these.
Eigen::Isometry3d movedGoal(const Eigen::Isometry3d& goal, const Eigen::Isometry3d& setpoint,
                            const HandInput& input, double dt);

}  // namespace robots
