#include "arm_control/motion/stream_goals.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "arm_control/motion/goals.h"

namespace robots {
namespace {

using kinematics::SpatialVector;

// These say how hard the simulated arm is to push: at a joint, and along and about the axes of the
// tip.
constexpr double kJointDamping = 2.0;  // N.m.s/rad, N.s/m
constexpr double kTipDamping = 50.0;   // N.s/m
constexpr double kTwistDamping = 1.0;  // N.m.s/rad

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

template <int N>
using Joints = Eigen::Matrix<double, N, 1>;

/// Returns the list as joints; an empty list stands for `otherwise` at each joint.
template <int N>
std::optional<Joints<N>> toJointsOr(double otherwise, const std::vector<double>& list) {
  if (list.empty()) return Joints<N>::Constant(otherwise);
  return toJoints<N>(list);
}

template <int N>
std::optional<Joints<N>> masked(const std::vector<double>& list, const std::vector<bool>& mask) {
  auto joints = toJoints<N>(list);
  if (!joints || mask.empty()) return joints;
  if (mask.size() != std::size_t{N}) return std::nullopt;
  for (int i = 0; i < N; ++i) (*joints)[i] *= mask[static_cast<std::size_t>(i)] ? 1 : 0;
  return joints;
}

SpatialVector together(const Eigen::Vector3d& linear, const Eigen::Vector3d& angular) {
  SpatialVector result;
  result << linear, angular;
  return result;
}

SpatialVector masked(const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                     const std::array<bool, 6>& mask) {
  SpatialVector result = together(linear, angular);
  for (int i = 0; i < 6; ++i) result[i] *= mask[static_cast<std::size_t>(i)] ? 1 : 0;
  return result;
}

}  // namespace

template <int N>
std::optional<JointStreamGoal<N>> streamGoal(const JointVelocityGoal& goal) {
  const auto rate = masked<N>(goal.goal, goal.mask);
  const auto acceleration = toJointsOr<N>(kUnbounded, goal.acceleration);
  const auto deceleration = toJointsOr<N>(kUnbounded, goal.deceleration);
  const auto guard = toJointsOr<N>(0, goal.guard);
  if (!rate || !acceleration || !deceleration || !guard) return std::nullopt;
  if (acceleration->minCoeff() <= 0 || deceleration->minCoeff() <= 0) return std::nullopt;
  JointStreamGoal<N> asked{*rate, {.change = {*acceleration, *deceleration}}};
  if (!goal.guard.empty()) asked.bounds.guard = *guard;
  return asked;
}

template <int N>
std::optional<JointStreamGoal<N>> streamGoal(const JointEffortGoal& goal) {
  const auto push = pushOf<N>(goal);
  if (!push) return std::nullopt;
  return JointStreamGoal<N>{push->effort / kJointDamping};
}

std::optional<TwistStreamGoal> streamGoal(const TwistGoal& goal) {
  const SpatialVector twist = masked(goal.linear, goal.angular, goal.mask);
  SpatialVector change = together(goal.linear_acceleration, goal.angular_acceleration);
  if (!canBeMeant(twist) || !canBeMeant(change) || change.minCoeff() < 0) return std::nullopt;
  change = (change.array() == 0).select(kUnbounded, change);
  return TwistStreamGoal{twist, {change, change}};
}

std::optional<TwistStreamGoal> streamGoal(const WrenchGoal& goal) {
  const auto wrench = pushOf(goal);
  if (!wrench) return std::nullopt;
  const SpatialVector twist =
      together(wrench->head<3>() / kTipDamping, wrench->tail<3>() / kTwistDamping);
  return TwistStreamGoal{.twist = twist};
}

template <int N>
std::optional<JointPush<N>> pushOf(const JointEffortGoal& goal) {
  const auto effort = masked<N>(goal.effort, goal.mask);
  if (!effort) return std::nullopt;
  JointPush<N> push{.effort = *effort, .released = MotionStream<N>::Mask::Constant(true)};
  if (!goal.mask.empty()) std::copy_n(goal.mask.begin(), N, push.released.begin());
  return push;
}

std::optional<SpatialVector> pushOf(const WrenchGoal& goal) {
  const SpatialVector wrench = masked(goal.force, goal.torque, goal.mask);
  if (!canBeMeant(wrench)) return std::nullopt;
  return wrench;
}

template std::optional<JointPush<6>> pushOf<6>(const JointEffortGoal& goal);
template std::optional<JointPush<7>> pushOf<7>(const JointEffortGoal& goal);
template std::optional<JointStreamGoal<6>> streamGoal<6>(const JointVelocityGoal& goal);
template std::optional<JointStreamGoal<7>> streamGoal<7>(const JointVelocityGoal& goal);
template std::optional<JointStreamGoal<6>> streamGoal<6>(const JointEffortGoal& goal);
template std::optional<JointStreamGoal<7>> streamGoal<7>(const JointEffortGoal& goal);

}  // namespace robots
