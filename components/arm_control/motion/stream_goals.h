#pragma once
// This computes what the goals of servo_jv, servo_jf, servo_cv and servo_cf ask a MotionStream to
// follow.

#include <optional>

#include "arm_control/motion/motion_stream.h"
#include "robot_types/cartesian.h"
#include "robot_types/joint_commands.h"

namespace robots {

template <int N>
struct JointStreamGoal {
  typename MotionStream<N>::Joints rate;  ///< rad/s or m/s
  typename MotionStream<N>::JointBounds bounds = {};
};

/// A JointPush is what servo_jf asks of motors.
template <int N>
struct JointPush {
  typename MotionStream<N>::Joints effort;  ///< N.m or N; 0 where it is not released
  typename MotionStream<N>::Mask released;
};

/// A TwistStreamGoal is along the axes in which the goal is given.
struct TwistStreamGoal {
  kinematics::SpatialVector twist;
  RateRamp<6>::Limits change = {};
};

/// Each of these returns none if the goal has a list of the wrong length, a number that
/// cannot be meant, or an acceleration that leads nowhere. Joints and axes outside of the mask hold
/// still, but a wrench does not press along these axes.
template <int N>
std::optional<JointStreamGoal<N>> streamGoal(const JointVelocityGoal& goal);
template <int N>
std::optional<JointStreamGoal<N>> streamGoal(const JointEffortGoal& goal);
/// An acceleration of 0 leaves its axis unbounded, because clients that do not know the field send
/// zeros.
std::optional<TwistStreamGoal> streamGoal(const TwistGoal& goal);
std::optional<TwistStreamGoal> streamGoal(const WrenchGoal& goal);

/// These two return what the goal asks of drives that control efforts; the ones above, how it moves
/// the set-point of others.
template <int N>
std::optional<JointPush<N>> pushOf(const JointEffortGoal& goal);
std::optional<kinematics::SpatialVector> pushOf(const WrenchGoal& goal);

}  // namespace robots
