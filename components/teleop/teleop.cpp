#include "teleop/teleop.h"

#include <algorithm>
#include <utility>

#include "parameters/valid_age.h"
#include "parameters/valid_time.h"
#include "registration/surgeon_view.h"
#include "teleop/valid_scale.h"

namespace robots {

namespace {

JawSettings jawSettings(const TeleopParameters& parameters) {
  return {.scale = parameters.jaw_scale,
          .offset = parameters.jaw_offset,
          .rate = parameters.jaw_rate,
          .ghost_rate = parameters.jaw_ghost_rate,
          .tolerance = parameters.jaw_tolerance};
}

}  // namespace

Teleop::Teleop(const TeleopParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      enableAtFirstCycle_(parameters.enable_at_start),
      jawFollower_(gripper_, jaw_, jawSettings(parameters), parameters.max_age) {
  settings_.scale = requireValidScale(parameters.scale);
  requireAge("max_age", parameters.max_age);
  requireAge("operator_age", parameters.operator_age);
  requireAge("registration_age", parameters.registration_age);
  requireTimeOrZero("preparation_limit", parameters.preparation_limit);
}

void Teleop::onStart() {
  teleoperation_.emit().teleop_state(state_);
  teleoperation_.emit().settings(settings_);
}

/// Stops, because nothing would watch a motion that went on.
void Teleop::onSuspend() {
  arms_.stopPreparing();
  if (state_ != TeleopState::Disabled) leave(TeleopState::Preparing);
}

/// Restarts the limit of preparation, which counts the time that it works and not the time that it
/// was suspended.
void Teleop::onResume() { preparation_.begin(); }

/// Stops, and comes back disabled from a restart: whoever finds out why it faulted enables it.
void Teleop::onFault() { disable(); }

void Teleop::enable() {
  arms_.permit();
  preparation_.begin();
  if (state_ == TeleopState::Disabled) enter(TeleopState::Preparing);
}

void Teleop::disable() {
  enableAtFirstCycle_ = false;  // disable() may come before the first cycle
  leave(TeleopState::Disabled);
}

void Teleop::set_scale(double scale) {
  settings_.scale = scale;
  settingsChanged();
}

void Teleop::lock_rotation(bool lock) {
  // The slave has not turned with its master while it was locked.
  if (settings_.rotation_locked && !lock) isTurned_ = true;
  settings_.rotation_locked = lock;
  settingsChanged();
}

void Teleop::lock_translation(bool lock) {
  settings_.translation_locked = lock;
  settingsChanged();
}

void Teleop::settingsChanged() {
  lawIsOld_ = true;
  teleoperation_.emit().settings(settings_);
}

void Teleop::run() {
  if (std::exchange(enableAtFirstCycle_, false)) enable();
  if (state_ == TeleopState::Disabled) return;
  const suture::Time now = suture::now();
  arms_.prepare();
  step(now);
  giveUpIfLate();
}

void Teleop::step(suture::Time now) {
  const auto poses = arms_.poses(parameters_.max_age);
  const bool sendsGoals = state_ == TeleopState::Following || offers_;
  if (arms_.slave().refuses() && sendsGoals) return giveUp(kGoalsRefused);
  const bool missed = cycles_.missed(std::max(parameters_.max_age, 3 * period()));
  const bool rebased = poses && poses->rebased;
  const bool fellSilent = arms_.slave().hasFallenSilent();
  if (arms_.slave().hasBrokenOff() || fellSilent || missed || rebased) {
    law_.reset();
    goal_.reset();
    jawFollower_.end();
  }
  const bool haveData = poses && knowsView();
  if (!haveData || !arms_.master().isUp() || !arms_.slave().ready()) {
    return leave(TeleopState::Preparing);
  }
  if (!operator_.teleoperates()) return rest(*poses);
  const bool begins = !law_ || isTurned_;
  if (begins && !arms_.slave().streams()) return offerGoal(TeleopState::Preparing, *poses);
  if (begins && !isAligned(*poses, now)) return offerGoal(TeleopState::Aligning, *poses);
  if (!arms_.ready()) return offerGoal(TeleopState::Preparing, *poses);
  isTurned_ = false;
  follow(*poses);
  if (state_ != TeleopState::Following) return;
  release_.release(poses->master.stamp);
  jawFollower_.follow(now);
}

/// Lets the slave hold while a pedal takes the master from it, or nobody is there to hold that.
void Teleop::rest(const ArmPoses& poses) {
  leave(TeleopState::Clutched);
  if (operator_.isPresent()) return release_.release(poses.master.stamp);
  release_.end();
}

/// Returns false if there is a registration, or will be, that has not answered lately. A slave that
/// follows goes on with the last one.
bool Teleop::knowsView() {
  const auto frames = registration_.frames();
  if (!frames || frames.age() > parameters_.registration_age) {
    return registration_.isAbsent() || law_;
  }
  const Eigen::Matrix3d view =
      surgeonView(*frames, parameters_.master_side, parameters_.slave_side);
  if (!view.isApprox(view_, 1e-12)) lawIsOld_ = true;
  view_ = view;
  return true;
}

bool Teleop::isAligned(const ArmPoses& poses, suture::Time now) {
  if (!parameters_.align || settings_.rotation_locked) return true;
  return alignment_.align(poses.master.pose, view_.transpose() * poses.slave.pose.linear(), now);
}

/// Asks the slave to stay where it was sent, or else where it is. That it does so shows that goals
/// reach it in time. The pose stays the same while the slave obeys, because its set-point comes
/// back late: a slave that was sent there again would repeat its last motion.
void Teleop::offerGoal(TeleopState state, const ArmPoses& poses) {
  const Eigen::Isometry3d goal = goal_ && arms_.slave().streams() ? *goal_ : poses.slave.pose;
  leave(state);
  if (!slave_.servo_cp({goal, poses.master.stamp, true})) return;
  goal_ = goal;
  offers_ = true;
}

void Teleop::follow(const ArmPoses& poses) {
  const PoseStamped& master = poses.master;
  const bool begins = !law_ || lawIsOld_;
  // With new settings it goes on from where the slave was sent, because the slave's set-point may
  // be some cycles behind.
  const Eigen::Isometry3d from = law_ ? law_->follow(master.pose) : poses.slave.pose;
  if (begins) law_.emplace(master.pose, from, lawSettings());
  lawIsOld_ = false;
  goal_ = law_->follow(master.pose);
  // The goal keeps the stamp of the master's data, so that its age is known wherever it arrives.
  if (!slave_.servo_cp({*goal_, master.stamp, true})) return leave(TeleopState::Preparing);
  if (begins) announce(master, from);
}

FollowSettings Teleop::lawSettings() const {
  return {.scale = settings_.scale,
          .view = view_,
          .rotation_locked = settings_.rotation_locked,
          .translation_locked = settings_.translation_locked};
}

/// Announces that it follows: the first goal is on its way to the slave.
void Teleop::announce(const PoseStamped& master, const Eigen::Isometry3d& slave) {
  offers_ = false;
  anchors_ = {.master_stamp = master.stamp,
              .master = master.pose,
              .slave_setpoint = slave,
              .scale = settings_.scale,
              .entry = anchors_.entry + 1,
              .view = view_,
              .rotation_locked = settings_.rotation_locked,
              .translation_locked = settings_.translation_locked};
  enter(TeleopState::Following);
  teleoperation_.emit().followed(anchors_);
}

bool Teleop::prepares() const {
  return state_ == TeleopState::Preparing || state_ == TeleopState::Aligning;
}

void Teleop::giveUpIfLate() {
  if (!prepares() || !preparation_.isOver()) return;
  if (state_ == TeleopState::Preparing) return giveUp(offers_ ? kGoalsNotTaken : kNotReadyInTime);
  giveUp(
      "the master has not turned to the slave's orientation in time; look at its warnings, then "
      "enable");
}

void Teleop::giveUp(const char* why) {
  leave(TeleopState::Disabled);
  messages_.error(why);
}

/// Ends following. A slave that can obey holds where it is, or stays there by the goals that it
/// gets while the master is aligned, and a master that is being turned holds, as does one that was
/// released and is not the surgeon's any more. Nor does an arm go on home for a teleoperation that
/// is disabled.
void Teleop::leave(TeleopState state) {
  law_.reset();
  goal_.reset();
  offers_ = false;
  if (state_ == TeleopState::Following && state != TeleopState::Aligning) arms_.holdSlave();
  if (state != TeleopState::Aligning) alignment_.end();
  if (state != TeleopState::Clutched) release_.end();
  if (state == TeleopState::Disabled) arms_.stopPreparing();
  jawFollower_.end();
  enter(state);
}

void Teleop::enter(TeleopState state) {
  if (state_ == state) return;
  const bool prepared = prepares();
  state_ = state;
  if (!prepared) preparation_.begin();
  teleoperation_.emit().teleop_state(state);
}

}  // namespace robots
