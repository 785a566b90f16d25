#include "arm_control/arm_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arm_control/motion/goals.h"
#include "timing/seconds.h"

namespace robots {
namespace {

// These are the activities that the arm reports when a command has led it to each of the states, in
// their order.
constexpr std::array<const char*, 5> kActivities{"", "", "holding", "paused", ""};

/// Returns whether it is so long that the drives have dropped the arm's last goal meanwhile.
bool isPause(suture::Time from, suture::Time to) { return to - from > StreamWatch::kSilence; }

bool mayHavePower(DrivePower power) { return power == DrivePower::Off || power == DrivePower::On; }

template <int N>
typename DriveWatch<N>::Bounds boundsOf(const ArmModel<N>& model) {
  typename DriveWatch<N>::Bounds bounds;
  for (int i = 0; i < N; ++i) {
    bounds[static_cast<std::size_t>(i)] = {.rate_limit = model.rate_limit[i],
                                           .effort_limit = model.effort_limit[i],
                                           .encoder_step = model.encoder_step[i]};
  }
  bounds.back() = model.tool;
  return bounds;
}

}  // namespace

template <int N>
ArmController<N>::ArmController(const ArmModel<N>& model)
    : model_(model),
      watch_(boundsOf(model), model.watch),
      inserted_(!model.insertion),
      setpoint_({.rate = model.rate_limit,
                 .acceleration = model.acceleration_limit,
                 .lower = model.chain.lower(),
                 .upper = model.chain.upper()}),
      motion_(model.joint_names) {}

template <int N>
void ArmController<N>::obey(StateCommand command) {
  const auto next = after(state_.state, command);
  if (!next) return refuse(command);
  if (command == StateCommand::Enable && !mayHavePower(reading_.power)) {
    return warnings_.tell(ArmWarning::PowerLost);
  }
  if (command == StateCommand::Home) return startMove(model_.home, true);
  if (command == StateCommand::Unhome) return unhome();
  desired_ = next;
  if (command == StateCommand::Enable) permitted_ = reading_.permitted;
  if (*next != state_.state) restIn(*next, kActivities[static_cast<std::size_t>(*next)]);
}

template <int N>
void ArmController<N>::refuse(StateCommand command) {
  if (command == StateCommand::Home) return warn(ArmWarning::NotEnabled);
  refusal_ = whyRefused(state_.state, command);
  warnings_.tell(ArmWarning::WrongState);
}

// An arm on its way home holds, or it would be homed again in a moment.
template <int N>
void ArmController<N>::unhome() {
  if (homing_ && setpoint_.isMoving()) hold();
  state_.is_homed = false;
  state_.stamp = suture::now();
  stateChanged_ = true;
}

template <int N>
void ArmController<N>::startAnew() {
  state_.is_homed = false;
  restIn(ArmState::Undefined, "");
}

template <int N>
void ArmController<N>::restIn(ArmState state, const char* activity) {
  endMove(false);
  setpoint_.rest(reading_.position);
  setpointStamp_ = {};
  watch_.resetOverloads();
  enter(state, activity);
}

template <int N>
void ArmController<N>::hold() {
  if (!mayMove()) return;
  endMove(false);
  setpoint_.stay();
  enter(ArmState::Enabled, "holding");
}

template <int N>
std::optional<typename ArmController<N>::ServoTarget> ArmController<N>::target(
    const PoseStamped& goal) {
  if (!mayMoveTip()) return std::nullopt;
  if (!isPose(goal)) return refused(ArmWarning::Malformed);
  const auto solution = model_.solve(goal.pose, setpoint(), kinematics::Postures::Near);
  if (!solution.found && !solution.limited) return refused(ArmWarning::OutOfReach);
  return ServoTarget{solution.q, solution.limited};
}

template <int N>
std::optional<typename ArmController<N>::ServoTarget> ArmController<N>::target(
    const JointGoal& goal) {
  if (!mayMove()) return std::nullopt;
  const auto q = toJoints<N>(goal.position);
  if (!q) return refused(ArmWarning::Malformed);
  return withinLimits(*q);
}

template <int N>
void ArmController<N>::servo_cp(const PoseStamped& goal) {
  if (const auto to = target(goal)) servo(*to, goal.stamp, "servo_cp");
}

template <int N>
void ArmController<N>::servo_jp(const JointGoal& goal) {
  if (const auto to = target(goal)) servo(*to, goal.stamp, "servo_jp");
}

template <int N>
void ArmController<N>::interpolate_cp(const PoseStamped& goal) {
  if (const auto to = target(goal)) interpolate(*to, goal.stamp, "interpolate_cp");
}

template <int N>
void ArmController<N>::interpolate_jp(const JointGoal& goal) {
  if (const auto to = target(goal)) interpolate(*to, goal.stamp, "interpolate_jp");
}

template <int N>
void ArmController<N>::move_jp(const JointGoal& goal) {
  if (!mayMove()) return;
  const auto q = toJoints<N>(goal.position);
  if (!q) return warn(ArmWarning::Malformed);
  if (!model_.chain.within(*q)) return warn(ArmWarning::OutOfReach);
  startMove(*q, false);
}

template <int N>
PoseStamped ArmController<N>::forward_kinematics(const JointGoal& goal) const {
  const auto q = toJoints<N>(goal.position);
  if (!q) return {};
  return {model_.chain.forward(*q), goal.stamp, true};
}

template <int N>
JointSolution ArmController<N>::inverse_kinematics(const PoseStamped& goal) const {
  JointSolution answer;
  if (!isPose(goal)) return answer;
  const auto solution = model_.solve(goal.pose, setpoint(), kinematics::Postures::All);
  std::copy_n(solution.q.data(), N, answer.position.begin());
  answer.joints = N;
  answer.found = solution.found;
  return answer;
}

template <int N>
void ArmController<N>::step(suture::Time now, const std::optional<DriveReading<N>>& drives) {
  const suture::Time measured = reading_.stamp;
  take(drives, now);
  // In a pause of either the drives have dropped the arm's last goal.
  const bool unheard = measured != suture::Time{} && isPause(measured, reading_.stamp);
  const bool paused = isPause(std::exchange(lastStep_, now), now) || unheard;
  if (state_.state == ArmState::Enabled) goOnFrom(paused);
  if (const auto joint = trailing()) {
    fail({ArmWarning::FollowingError, *joint}, "following error");
  }
  if (servoing_.hasFallenSilent(now)) hold();
  if (setpoint_.step(now)) endMove(true);
  publish(now);
}

/// After a pause the arm does not go on with what it did, but does what it was asked for since
/// then. That begins where the joints are, and so does all that is asked for before the drives have
/// power: else the set-point would run ahead, and the joints after it.
template <int N>
void ArmController<N>::goOnFrom(bool paused) {
  if (paused && !setpoint_.hasBegun()) return restIn(ArmState::Enabled, "holding");
  if (!paused && reading_.power == DrivePower::On) return;
  setpoint_.beginAnew(reading_.position, lastStep_);
  watch_.resetOverloads();
}

template <int N>
void ArmController<N>::take(const std::optional<DriveReading<N>>& drives, suture::Time now) {
  const bool wasHeard = std::exchange(heard_, drives.has_value());
  if (drives) {
    reading_ = *drives;
    const auto fault = watch_.look(reading_, now);
    obeyInsertion();
    obeyPower();
    if (fault) obey(*fault);
    // Without power the brakes hold the joints; after a silence they may be anywhere.
    if (!powered() || !wasHeard) setpoint_.put(reading_.position);
  } else if (powered()) {
    restIn(ArmState::Fault, "drives silent");
    warnings_.tell(ArmWarning::DrivesSilent);
  }
}

// A stop may be over before the arm looks, so it also compares when power was permitted.
template <int N>
void ArmController<N>::obeyPower() {
  const bool isLost = !mayHavePower(reading_.power) || reading_.permitted != permitted_;
  if (state_.state == ArmState::Undefined && mayHavePower(reading_.power)) {
    restIn(ArmState::Disabled, "");
  } else if (powered() && isLost) {
    restIn(ArmState::Disabled, "");
    warnings_.tell(ArmWarning::PowerLost);
  }
}

template <int N>
void ArmController<N>::obeyInsertion() {
  if (!model_.insertion) return;
  const InsertionRule& rule = *model_.insertion;
  const Eigen::Isometry3d frame = model_.chain.link(reading_.position, rule.joints);
  inserted_ = frame.translation().norm() >= rule.least + (inserted_ ? 0 : rule.buffer);
}

template <int N>
std::optional<int> ArmController<N>::trailing() const {
  if (state_.state != ArmState::Enabled) return std::nullopt;
  const Joints error = model_.chain.clamp(setpoint()) - reading_.position;
  for (int i = 0; i < N; ++i) {
    if (std::abs(error[i]) > model_.following_error[i]) return i;
  }
  return std::nullopt;
}

// After a jump the arm does not know where it is, with power or without.
template <int N>
void ArmController<N>::obey(const DriveFault& fault) {
  const bool jumped = fault.reason == ArmWarning::EncoderJump;
  if (jumped && state_.is_homed) unhome();
  if (powered()) {
    fail(fault, jumped ? "encoder jump" : "over-current");
  } else if (jumped) {
    tell(fault);
  }
}

template <int N>
void ArmController<N>::tell(const DriveFault& fault) {
  faultyJoint_ =
      fault.joint < N ? model_.joint_names[static_cast<std::size_t>(fault.joint)] : "jaw";
  warnings_.tell(fault.reason);
}

template <int N>
void ArmController<N>::fail(const DriveFault& fault, const char* activity) {
  restIn(ArmState::Fault, activity);
  tell(fault);
}

template <int N>
bool ArmController<N>::mayMove() {
  if (state_.state == ArmState::Enabled) return true;
  warn(ArmWarning::NotEnabled);
  return false;
}

template <int N>
bool ArmController<N>::mayMoveTip() {
  if (!mayMove()) return false;
  if (!state_.is_homed) {
    warn(ArmWarning::NotHomed);
  } else if (!inserted_) {
    warn(ArmWarning::NotInserted);
  }
  return state_.is_homed && inserted_;
}

template <int N>
void ArmController<N>::enter(ArmState state, const char* activity) {
  const bool busy = setpoint_.isMoving();
  warnings_.obey();
  if (state_.state == state && state_.sub_state == activity && state_.is_busy == busy) return;
  state_.state = state;
  state_.sub_state = activity;
  state_.is_busy = busy;
  state_.stamp = suture::now();
  stateChanged_ = true;
}

template <int N>
void ArmController<N>::startMove(const Joints& goal, bool homing) {
  endMove(false);
  setpoint_.move(goal, lastStep_);
  homing_ = homing;
  setpointStamp_ = {};
  enter(ArmState::Enabled, homing ? "homing" : "moving");
}

template <int N>
void ArmController<N>::endMove(bool reached) {
  servoing_.end();
  streamer_ = nullptr;
  sliding_ = false;
  if (!setpoint_.end()) return;
  moveEnded_ = reached;
  if (!reached) return;
  state_.is_homed = state_.is_homed || homing_;
  enter(ArmState::Enabled, "holding");
}

template <int N>
void ArmController<N>::follow(const Joints& setpoint, suture::Time goalStamp,
                              const char* activity) {
  endMove(false);
  setpoint_.put(setpoint);
  setpointStamp_ = goalStamp;
  enter(ArmState::Enabled, activity);
}

template <int N>
void ArmController<N>::followStream(const Joints& setpoint, suture::Time goalStamp,
                                    const char* activity) {
  follow(setpoint, goalStamp, activity);
  streamer_ = asking();
}

template <int N>
typename ArmController<N>::ServoTarget ArmController<N>::withinLimits(const Joints& q) const {
  return {model_.chain.clamp(q), !model_.chain.within(q)};
}

template <int N>
void ArmController<N>::servo(const ServoTarget& target, suture::Time goalStamp,
                             const char* activity) {
  if (!setpoint_.mayBePut(target.q, model_.servo_horizon)) return warn(ArmWarning::StepTooFar);
  const bool slid = sliding_;
  followStream(target.q, goalStamp, activity);
  servoing_.ask();
  slide(target.limited, slid);
}

template <int N>
void ArmController<N>::interpolate(const ServoTarget& target, suture::Time goalStamp,
                                   const char* activity) {
  const double wanted = setpoint_.untilNextGoal(lastStep_);
  const bool slid = sliding_;
  followStream(setpoint(), goalStamp, activity);
  setpoint_.interpolate(target.q, lastStep_, wanted);
  slide(target.limited, slid);
}

template <int N>
void ArmController<N>::slide(bool limited, bool slid) {
  sliding_ = limited;
  if (limited && !slid) warnings_.tell(ArmWarning::AtLimit);
}

template <int N>
void ArmController<N>::forgetNews() {
  stateChanged_ = false;
  moveEnded_.reset();
  desired_.reset();
  warnings_.forgetNews();
}

template <int N>
void ArmController<N>::clientGone(const suture::ConnectedClient& client) {
  if (&client != streamer_) return;
  hold();
  warnings_.tell(ArmWarning::ClientGone);
}

template <int N>
void ArmController<N>::publish(suture::Time now) {
  const bool known = reading_.stamp != suture::Time{};
  motion_.setMeasured(reading_, model_.chain.forward(reading_.position), heard_ && known);
  const suture::Time stamp = setpointStamp_ == suture::Time{} ? now : setpointStamp_;
  motion_.setSetpoint(setpoint(), now, model_.chain.forward(setpoint()), stamp, known);
}

template class ArmController<6>;
template class ArmController<7>;

}  // namespace robots
