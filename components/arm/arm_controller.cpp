#include "arm/simulated_arm.h"

#include <algorithm>

#include "arm/goals.h"
#include "arm/kinematics/inverse.h"
#include "arm/seconds.h"

namespace robots {
namespace {

// The arm says these of what it does when it has just entered each of the states, in their order.
constexpr std::array<const char*, 5> kActivities{"", "", "holding", "paused", "following error"};

template <int N>
JointState blank(const std::array<const char*, std::size_t{N}>& names) {
  JointState state;
  state.name.assign(names.begin(), names.end());
  state.position.resize(N);
  return state;
}

template <int N>
void place(JointState& state, const Eigen::Matrix<double, N, 1>& position, suture::Time stamp) {
  std::copy_n(position.data(), N, state.position.begin());
  state.stamp = stamp;
  state.valid = true;
}

}  // namespace

template <int N>
SimulatedArm<N>::SimulatedArm(const ArmModel<N>& model)
    : model_(model),
      dynamics_(model.time_constant, model.rate_limit, model.chain.lower(), model.chain.upper(),
                model.parked),
      setpoint_(dynamics_.setpoint()),
      measuredJs_(blank<N>(model.joint_names)),
      setpointJs_(measuredJs_) {
  measuredJs_.velocity.resize(N);
  state_.state = ArmState::Disabled;
}

template <int N>
void SimulatedArm<N>::obey(StateCommand command) {
  const auto next = after(state_.state, command);
  if (!next) return refuse(command);
  if (command == StateCommand::Home) return startMove(model_.home, true);
  if (command == StateCommand::Unhome) return unhome();
  desired_ = next;
  if (*next != state_.state) restIn(*next);
}

template <int N>
void SimulatedArm<N>::refuse(StateCommand command) {
  if (command == StateCommand::Home) return warn(ArmWarning::NotEnabled);
  refusal_ = whyRefused(command);
  warnings_.tell(ArmWarning::WrongState);
}

template <int N>
void SimulatedArm<N>::unhome() {
  state_.is_homed = false;
  state_.stamp = suture::now();
  stateChanged_ = true;
}

template <int N>
void SimulatedArm<N>::restIn(ArmState state) {
  endMove(false);
  setpoint_ = dynamics_.measured();
  setpointStamp_ = {};
  enter(state, kActivities[static_cast<std::size_t>(state)]);
}

template <int N>
void SimulatedArm<N>::hold() {
  if (!mayMove()) return;
  endMove(false);
  enter(ArmState::Enabled, "holding");
}

template <int N>
void SimulatedArm<N>::servo_cp(const PoseStamped& goal) {
  if (!mayMove()) return;
  if (!isPose(goal)) return warn(ArmWarning::Malformed);
  const auto solution = kinematics::inverse(model_.chain, goal.pose, setpoint_);
  if (!solution.found && !solution.limited) return warn(ArmWarning::OutOfReach);
  servo({solution.q, solution.limited}, goal.stamp, "servo_cp");
}

template <int N>
void SimulatedArm<N>::servo_jp(const JointGoal& goal) {
  if (!mayMove()) return;
  const auto q = toJoints<N>(goal.position);
  if (!q) return warn(ArmWarning::Malformed);
  servo(withinLimits(*q), goal.stamp, "servo_jp");
}

template <int N>
void SimulatedArm<N>::move_jp(const JointGoal& goal) {
  if (!mayMove()) return;
  const auto q = toJoints<N>(goal.position);
  if (!q) return warn(ArmWarning::Malformed);
  if (!model_.chain.within(*q)) return warn(ArmWarning::OutOfReach);
  startMove(*q, false);
}

template <int N>
PoseStamped SimulatedArm<N>::forward_kinematics(const JointGoal& goal) const {
  const auto q = toJoints<N>(goal.position);
  if (!q) return {};
  return {model_.chain.forward(*q), goal.stamp, true};
}

template <int N>
JointSolution SimulatedArm<N>::inverse_kinematics(const PoseStamped& goal) const {
  JointSolution answer;
  if (!isPose(goal)) return answer;
  const auto solution = kinematics::inverse(model_.chain, goal.pose, setpoint_);
  std::copy_n(solution.q.data(), N, answer.position.begin());
  answer.joints = N;
  answer.found = solution.found;
  return answer;
}

template <int N>
void SimulatedArm<N>::step(suture::Time now) {
  if (lastStep_ != suture::Time{}) dynamics_.advance(secondsBetween(lastStep_, now));
  lastStep_ = now;
  if (trails()) {
    restIn(ArmState::Fault);
    warnings_.tell(ArmWarning::FollowingError);
  }
  if (servoing_.hasFallenSilent(now)) hold();
  if (move_) {
    if (moveStart_ == suture::Time{}) moveStart_ = now;
    const double t = secondsBetween(moveStart_, now);
    setpoint_ = move_->at(t);
    if (t >= move_->duration()) endMove(true);
  }
  dynamics_.command(setpoint_);
  publish(now);
}

// The joints have had a cycle to follow what they were commanded.
template <int N>
bool SimulatedArm<N>::trails() const {
  const Joints error = dynamics_.setpoint() - dynamics_.measured();
  return state_.state == ArmState::Enabled &&
         (error.cwiseAbs().array() > model_.following_error.array()).any();
}

template <int N>
bool SimulatedArm<N>::mayMove() {
  if (state_.state == ArmState::Enabled) return true;
  warn(ArmWarning::NotEnabled);
  return false;
}

template <int N>
void SimulatedArm<N>::enter(ArmState state, const char* activity) {
  const bool busy = move_.has_value();
  warnings_.obey();
  if (state_.state == state && state_.sub_state == activity && state_.is_busy == busy) return;
  state_.state = state;
  state_.sub_state = activity;
  state_.is_busy = busy;
  state_.stamp = suture::now();
  stateChanged_ = true;
}

template <int N>
void SimulatedArm<N>::startMove(const Joints& goal, bool homing) {
  endMove(false);
  move_.emplace(setpoint_, goal, moveRatio_ * model_.rate_limit);
  moveStart_ = {};
  homing_ = homing;
  setpointStamp_ = {};
  enter(ArmState::Enabled, homing ? "homing" : "moving");
}

template <int N>
void SimulatedArm<N>::endMove(bool reached) {
  servoing_.end();
  streamer_ = nullptr;
  sliding_ = false;
  if (!move_) return;
  move_.reset();
  moveEnded_ = reached;
  if (!reached) return;
  state_.is_homed = state_.is_homed || homing_;
  enter(ArmState::Enabled, "holding");
}

template <int N>
void SimulatedArm<N>::follow(const Joints& setpoint, suture::Time goalStamp, const char* activity) {
  endMove(false);
  setpoint_ = setpoint;
  setpointStamp_ = goalStamp;
  enter(ArmState::Enabled, activity);
}

template <int N>
void SimulatedArm<N>::followStream(const Joints& setpoint, suture::Time goalStamp,
                                   const char* activity) {
  follow(setpoint, goalStamp, activity);
  streamer_ = asking();
}

template <int N>
typename SimulatedArm<N>::ServoTarget SimulatedArm<N>::withinLimits(const Joints& q) const {
  return {model_.chain.clamp(q), !model_.chain.within(q)};
}

template <int N>
void SimulatedArm<N>::servo(const ServoTarget& target, suture::Time goalStamp,
                            const char* activity) {
  const Joints furthest = model_.servo_horizon * model_.rate_limit;
  const Joints step = target.q - setpoint_;
  if ((step.cwiseAbs().array() > furthest.array()).any()) return warn(ArmWarning::StepTooFar);
  const bool slid = sliding_;
  followStream(target.q, goalStamp, activity);
  servoing_.ask();
  sliding_ = target.limited;
  if (sliding_ && !slid) warnings_.tell(ArmWarning::AtLimit);
}

template <int N>
void SimulatedArm<N>::clientGone(const suture::ConnectedClient& client) {
  if (&client != streamer_) return;
  hold();
  warnings_.tell(ArmWarning::ClientGone);
}

template <int N>
void SimulatedArm<N>::publish(suture::Time now) {
  place<N>(measuredJs_, dynamics_.measured(), now);
  Joints::Map(measuredJs_.velocity.data()) = dynamics_.velocity();
  place<N>(setpointJs_, setpoint_, now);
  measuredCp_ = {model_.chain.forward(dynamics_.measured()), now, true};
  const suture::Time stamp = setpointStamp_ == suture::Time{} ? now : setpointStamp_;
  setpointCp_ = {model_.chain.forward(setpoint_), stamp, true};
}

template class SimulatedArm<6>;
template class SimulatedArm<7>;

}  // namespace robots
