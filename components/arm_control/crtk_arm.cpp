#include "arm_control/crtk_arm.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "arm_control/motion/goals.h"
#include "arm_control/motion/shortened.h"
#include "timing/seconds.h"

namespace robots {
namespace {

/// Appends a bound to both lists; leaves them empty if the quantity has none.
void bound(double most, std::vector<double>& lower, std::vector<double>& upper) {
  if (!std::isfinite(most)) return;
  lower.push_back(-most);
  upper.push_back(most);
}

}  // namespace

template <int N>
CrtkArm<N>::CrtkArm(ArmController<N>& arm)
    : arm_(arm), goalJs_(arm.motion().setpoint_js()), tip_(arm.model_) {
  const ArmModel<N>& model = arm_.model_;
  base_.valid = true;
  for (int i = 0; i < N; ++i) {
    const double rate = model.rate_limit[i];
    configuration_.name.emplace_back(model.joint_names[static_cast<std::size_t>(i)]);
    configuration_.type.push_back(model.chain.kind(i) == kinematics::JointKind::Revolute
                                      ? JointType::Revolute
                                      : JointType::Prismatic);
    configuration_.position_min.push_back(model.chain.lower()[i]);
    configuration_.position_max.push_back(model.chain.upper()[i]);
    configuration_.velocity_min.push_back(-rate);
    configuration_.velocity_max.push_back(rate);
    bound(model.acceleration_limit[i], configuration_.acceleration_min,
          configuration_.acceleration_max);
    bound(model.effort_limit[i], configuration_.effort_min, configuration_.effort_max);
  }
  configuration_.valid = true;
  moveGoal_.position.reserve(kMaxJoints);
  ofJoint_.reserve(255);
}

// --- the state machine

template <int N>
void CrtkArm<N>::state_command(const std::string& name) {
  if (const auto command = stateCommandNamed(name)) return arm_.obey(*command);
  error_ = "state_command: enable, disable, pause, resume, home or unhome";
}

// --- frames

template <int N>
PoseStamped CrtkArm<N>::inReference(PoseStamped pose) const {
  pose.pose = base_.transform * pose.pose;
  return pose;
}

template <int N>
PoseStamped CrtkArm<N>::inBase(PoseStamped pose) const {
  pose.pose = base_.transform.inverse() * pose.pose;
  return pose;
}

template <int N>
void CrtkArm<N>::nameFrames(const suture::Frames& frames) {
  referenceFrame_ = suture::frameId(frames.reference);
  base_.reference_frame = base_.moving_frame = referenceFrame_;  // until somebody sets another
  tip_.nameFrames(suture::frameId(frames.moving), referenceFrame_, base_.moving_frame);
}

template <int N>
void CrtkArm<N>::set_base_frame(const TransformStamped& base) {
  if (!base.valid || !isRigid(base.transform)) return arm_.warn(ArmWarning::Malformed);
  if (referenceFrame_ != 0 && base.reference_frame != referenceFrame_) {
    return arm_.warn(ArmWarning::WrongFrame);
  }
  // The goals of a stream were made in the previous frame, so the stream must not go on in the new
  // one, also if something else has ended it here and its client has not heard of that.
  const OperatingState& now = arm_.operating_state();
  const bool moves = now.state == ArmState::Enabled && now.sub_state != "holding";
  if (moves || referred_.isActive()) {
    return arm_.warn(ArmWarning::InMotion);
  }
  base_ = base;
  base_.transform = exact(base.transform);
  tip_.nameBase(base_.moving_frame);
}

template <int N>
PoseStamped CrtkArm<N>::stepped(const Joints& from, const PoseStamped& step) const {
  PoseStamped goal{arm_.model_.chain.forward(from), step.stamp, step.valid};
  goal.pose.translation() += base_.transform.linear().transpose() * step.pose.translation();
  goal.pose.linear() = goal.pose.linear() * step.pose.linear();
  return goal;
}

// --- motion

template <int N>
void CrtkArm<N>::free() {
  if (!arm_.mayMove()) return;
  arm_.follow(arm_.setpoint(), {}, "free");
  stream_.release("free");
}

template <int N>
void CrtkArm<N>::use_gravity_compensation(bool use) {
  gravityCompensation_ = use;
  gravityChanged_ = true;
}

template <int N>
std::optional<typename ArmController<N>::ServoTarget> CrtkArm<N>::stepped(const Joints& from,
                                                                          const JointGoal& step) {
  if (!arm_.mayMove()) return std::nullopt;
  const auto q = toJoints<N>(step.position);
  if (!q) return arm_.refused(ArmWarning::Malformed);
  return arm_.withinLimits(from + *q);
}

template <int N>
void CrtkArm<N>::servo_jr(const JointGoal& step) {
  if (const auto to = stepped(arm_.setpoint(), step)) arm_.servo(*to, step.stamp, "servo_jr");
}

template <int N>
void CrtkArm<N>::interpolate_jr(const JointGoal& step) {
  const auto to = stepped(arm_.setpoint_.endOfLine(), step);
  if (to) arm_.interpolate(*to, step.stamp, "interpolate_jr");
}

template <int N>
void CrtkArm<N>::interpolate_cp(const PoseStamped& goal) {
  referred_.ask();
  arm_.interpolate_cp(inBase(goal));
}

template <int N>
void CrtkArm<N>::interpolate_cr(const PoseStamped& step) {
  referred_.ask();
  if (!isPose(step)) return arm_.warn(ArmWarning::Malformed);
  arm_.interpolate_cp(stepped(arm_.setpoint_.endOfLine(), step));
}

template <int N>
void CrtkArm<N>::servo_jv(const JointVelocityGoal& goal) {
  drive(streamGoal<N>(goal), "servo_jv");
}

template <int N>
void CrtkArm<N>::servo_jf(const JointEffortGoal& goal) {
  constexpr const char* kActivity = "servo_jf";
  if (!arm_.reading_.controls_effort) return drive(streamGoal<N>(goal), kActivity);
  const auto push = pushOf<N>(goal);
  if (!streams(arm_.mayMove(), push.has_value(), kActivity)) return;
  stream_.push(push->effort, push->released, kActivity);
}

template <int N>
void CrtkArm<N>::drive(const std::optional<JointStreamGoal<N>>& goal, const char* activity) {
  if (!streams(arm_.mayMove(), goal.has_value(), activity)) return;
  const Joints& limit = arm_.model_.rate_limit;
  stream_.follow(goal->rate.cwiseMax(-limit).cwiseMin(limit), activity, goal->bounds);
}

template <int N>
void CrtkArm<N>::servo_cp(const PoseStamped& goal) {
  referred_.ask();
  arm_.servo_cp(inBase(goal));
}

template <int N>
void CrtkArm<N>::servo_cr(const PoseStamped& step) {
  referred_.ask();
  if (!isPose(step)) return arm_.warn(ArmWarning::Malformed);
  arm_.servo_cp(stepped(arm_.setpoint(), step));
}

template <int N>
void CrtkArm<N>::servo_cv(const TwistGoal& goal) {
  referred_.ask();
  const Eigen::Matrix3d toBase = base_.transform.inverse().linear();
  drive(Stream::Kind::SpatialTwist, streamGoal(goal), "servo_cv", toBase);
}

template <int N>
void CrtkArm<N>::body_servo_cf(const WrenchGoal& goal) {
  press(Stream::Kind::BodyWrench, Stream::Kind::BodyTwist, goal);
}

template <int N>
void CrtkArm<N>::spatial_servo_cf(const WrenchGoal& goal) {
  press(Stream::Kind::SpatialWrench, Stream::Kind::SpatialTwist, goal);
}

template <int N>
void CrtkArm<N>::press(typename Stream::Kind wrench, typename Stream::Kind twist,
                       const WrenchGoal& goal) {
  constexpr const char* kActivity = "servo_cf";
  if (!arm_.reading_.controls_effort) {
    return drive(twist, streamGoal(goal), kActivity, Eigen::Matrix3d::Identity());
  }
  const auto push = pushOf(goal);
  if (!streams(arm_.mayMoveTip(), push.has_value(), kActivity)) return;
  stream_.push(wrench, *push, kActivity);
}

template <int N>
void CrtkArm<N>::drive(typename Stream::Kind kind, const std::optional<TwistStreamGoal>& goal,
                       const char* activity, const Eigen::Matrix3d& axes) {
  if (!streams(arm_.mayMoveTip(), goal.has_value(), activity)) return;
  stream_.follow(kind, goal->twist, activity, {.change = goal->change, .axes = axes});
}

template <int N>
void CrtkArm<N>::move_jr(const JointGoal& step) {
  moveGoal_.position = step.position;
  moveGoal_.stamp = step.stamp;
  for (std::size_t i = 0; i < step.position.size() && i < std::size_t{N}; ++i) {
    moveGoal_.position[i] += arm_.setpoint()[static_cast<Eigen::Index>(i)];
  }
  arm_.move_jp(moveGoal_);
}

template <int N>
void CrtkArm<N>::move_cr(const PoseStamped& step) {
  if (!isPose(step)) return arm_.warn(ArmWarning::Malformed);
  moveTo(stepped(arm_.setpoint(), step));
}

template <int N>
void CrtkArm<N>::moveTo(const PoseStamped& goal) {
  if (!arm_.mayMoveTip()) return;
  if (!isPose(goal)) return arm_.warn(ArmWarning::Malformed);
  const auto solution = arm_.model_.solve(goal.pose, arm_.setpoint(), kinematics::Postures::All);
  if (!solution.found) return arm_.warn(ArmWarning::OutOfReach);
  arm_.startMove(solution.q, false);
}

template <int N>
void CrtkArm<N>::setRatios(double velocity, double acceleration) {
  ratioV_ = velocity;
  ratioA_ = acceleration;
  arm_.setpoint_.limitMoves({velocity, acceleration});
  ratiosChanged_ = true;
}

// --- questions

template <int N>
PoseStamped CrtkArm<N>::forward_kinematics(const JointGoal& q) const {
  return inReference(arm_.forward_kinematics(q));
}

template <int N>
JointSolution CrtkArm<N>::inverse_kinematics(const PoseStamped& goal) const {
  return arm_.inverse_kinematics(inBase(goal));
}

template <int N>
PoseStamped CrtkArm<N>::local_query_cp(const JointGoal& q) const {
  if (q.position.size() > std::size_t{N}) return {};
  Joints joints = Joints::Zero();
  std::copy(q.position.begin(), q.position.end(), joints.data());
  if (!canBeMeant(joints)) return {};
  return {arm_.model_.chain.link(joints, static_cast<int>(q.position.size())), q.stamp, true};
}

// --- streams

/// Ends a stream that another command replaced, even if that command is over already, so that a
/// stream that begins anew begins from rest.
template <int N>
void CrtkArm<N>::endPreviousStream() {
  if (!streaming()) stream_.end();
}

template <int N>
bool CrtkArm<N>::streams(bool may, bool isWellFormed, const char* activity) {
  if (!may) return false;
  if (!isWellFormed) {
    arm_.warn(ArmWarning::Malformed);
    return false;
  }
  endPreviousStream();
  arm_.followStream(arm_.setpoint(), {}, activity);
  return true;
}

template <int N>
MotorOrder<N> CrtkArm<N>::motorOrder() const {
  MotorOrder<N> order;
  if (streaming()) {
    const ArmModel<N>& model = arm_.model_;
    order = stream_.motors(model.chain, arm_.reading_.position, model.effort_limit);
  }
  order.compensation = gravityCompensation_;
  return order;
}

template <int N>
bool CrtkArm<N>::streaming() const {
  return stream_.isActive() && arm_.state_.state == ArmState::Enabled &&
         arm_.state_.sub_state == stream_.activity();
}

template <int N>
void CrtkArm<N>::advance(suture::Time now) {
  periods_.cycle(now);
  const double dt = lastCycle_ == suture::Time{} ? 0 : secondsBetween(lastCycle_, now);
  lastCycle_ = now;
  if (referred_.hasFallenSilent(now)) referred_.end();
  endPreviousStream();
  // After such a pause the drives have dropped the arm's last goal, so the arm does not go on with
  // it.
  const bool paused = stream_.isActive() && dt > inSeconds(StreamWatch::kSilence);
  if (stream_.hasFallenSilent(now) || paused) return arm_.hold();
  if (stream_.isOfTip() && !arm_.mayMoveTip()) return arm_.hold();
  const auto next = stream_.next(arm_.model_.chain, arm_.model_.inverse, arm_.setpoint(),
                                 arm_.reading_.position, dt);
  if (!next && !streamFails_) arm_.warnings_.tell(ArmWarning::OutOfReach);
  streamFails_ = !next;
  if (!next) return;
  // Beside a singularity the joints of two close poses may lie far apart.
  const Joints step = next->q - arm_.setpoint();
  arm_.setpoint_.put(arm_.setpoint() + shortened<Joints>(step, dt * arm_.model_.rate_limit));
  if (next->limited && !streamSlides_) arm_.warnings_.tell(ArmWarning::AtLimit);
  streamSlides_ = next->limited;
}

// --- reads and events

template <int N>
void CrtkArm<N>::publish(suture::Time now) {
  tip_.measured(arm_.reading_, arm_.motion().measured_cp(), base_.transform);
  tip_.asked(arm_.setpoint(), arm_.setpoint_.rate(), base_.transform, now,
             arm_.motion().setpoint_js().valid);
  const Joints goal = arm_.setpoint_.endOfMove();
  std::copy_n(goal.data(), N, goalJs_.position.begin());
  goalJs_.stamp = now;
  goalJs_.valid = arm_.motion().setpoint_js().valid;
  goalCp_ = {arm_.model_.chain.forward(goal), now, goalJs_.valid};
}

template <int N>
std::string_view CrtkArm<N>::textOf(ArmWarning reason) {
  if (reason == ArmWarning::WrongState) return arm_.refusal_;
  if (!isOfJoint(reason)) return robots::textOf(reason);
  ofJoint_ = arm_.faultyJoint_;
  ofJoint_ += ": ";
  return ofJoint_ += robots::textOf(reason);
}

template class CrtkArm<6>;
template class CrtkArm<7>;

}  // namespace robots
