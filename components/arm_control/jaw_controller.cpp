#include "arm_control/jaw_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arm_control/motion/goals.h"
#include "timing/seconds.h"

namespace robots {

JawController::JawController(const JawModel& model, const ArmController<6>& arm)
    : model_(model),
      arm_(arm),
      setpoint_({.rate = Joint(model.rate_limit),
                 .acceleration = Joint(model.acceleration_limit),
                 .lower = Joint(model.lower),
                 .upper = Joint(model.upper)}),
      configuration_(toolConfiguration("jaw", model.lower, model.upper)),
      measuredJs_(blankToolState("jaw")),
      setpointJs_(measuredJs_) {
  configuration_.velocity_min.assign(1, -model.rate_limit);
  configuration_.velocity_max.assign(1, model.rate_limit);
  configuration_.acceleration_min.assign(1, -model.acceleration_limit);
  configuration_.acceleration_max.assign(1, model.acceleration_limit);
  configuration_.effort_min.assign(1, -model.effort_limit);
  configuration_.effort_max.assign(1, model.effort_limit);
  measuredJs_.velocity.assign(1, 0);
  measuredJs_.effort.assign(1, 0);
  setpointJs_.effort.assign(1, 0);
}

bool JawController::mayMove() {
  if (isEnabled()) return true;
  warnings_.warn(ArmWarning::NotEnabled);
  return false;
}

void JawController::servo_jp(const JointGoal& goal) {
  if (!mayMove()) return;
  const auto q = toJoints<1>(goal.position);
  if (!q) return warnings_.warn(ArmWarning::Malformed);
  const double within = std::clamp(q->value(), model_.lower, model_.upper);
  const bool wasLimited = limited_;
  begin(Activity::Following);
  goal_ = within;
  limited_ = within != q->value();
  if (limited_ && !wasLimited) warnings_.tell(ArmWarning::AtLimit);
}

void JawController::servo_jf(const JointEffortGoal& goal) {
  if (!mayMove()) return;
  const auto effort = toJoints<1>(goal.effort);
  if (!effort || goal.mask.size() > 1) return warnings_.warn(ArmWarning::Malformed);
  begin(Activity::Pushing);
  const bool counts = goal.mask.empty() || goal.mask.front();
  effort_ = counts ? std::clamp(effort->value(), -model_.effort_limit, model_.effort_limit) : 0;
}

void JawController::move_jp(const JointGoal& goal) {
  if (!mayMove()) return;
  const auto q = toJoints<1>(goal.position);
  if (!q) return warnings_.warn(ArmWarning::Malformed);
  if (q->value() < model_.lower || q->value() > model_.upper) {
    return warnings_.warn(ArmWarning::OutOfReach);
  }
  begin(Activity::Moving);
  setpoint_.move(*q, lastStep_);
}

void JawController::hold() {
  begin(Activity::Holding);
  setpoint_.rest(setpoint_.joints());
}

void JawController::begin(Activity activity) {
  endMove(false);
  stream_.end();
  effort_ = 0;
  limited_ = false;
  activity_ = activity;
  const bool streams = activity == Activity::Following || activity == Activity::Pushing;
  if (streams) stream_.ask();
  streamer_ = streams ? arm_.asking() : nullptr;
  if (activity != Activity::Holding) warnings_.obey();
}

void JawController::endMove(bool reached) {
  if (setpoint_.end()) moveEnded_ = reached;
}

void JawController::clientGone(const suture::ConnectedClient& client) {
  if (&client != streamer_) return;
  hold();
  warnings_.tell(ArmWarning::ClientGone);
}

void JawController::step(suture::Time now, const std::optional<DriveReading<6>>& drives) {
  const suture::Time last = std::exchange(lastStep_, now);
  const double dt = last == suture::Time{} ? 0 : secondsBetween(last, now);
  // In a pause of the arm or its drives these have dropped the last goal, so the jaw does not go on
  // with it. A move that was asked for since then begins where the jaw is, and so does one that is
  // asked for before the drives have power.
  const bool unheard = drives && measuredJs_.stamp != suture::Time{} &&
                       drives->stamp - measuredJs_.stamp > StreamWatch::kSilence;
  const bool paused = dt > inSeconds(StreamWatch::kSilence) || unheard;
  const bool unpowered = drives && drives->power != DrivePower::On;
  const bool obeys = isEnabled();
  const bool rests = std::exchange(obeyed_, obeys) && !obeys;
  const bool stops = !obeys || paused || stream_.hasFallenSilent(now);
  const bool begins = obeys && setpoint_.isMoving() && (paused ? setpoint_.hasBegun() : unpowered);
  if (activity_ != Activity::Holding && stops && !begins) hold();
  const bool wasHeard = std::exchange(measuredJs_.valid, drives.has_value());
  if (drives) {
    take(*drives);
    const Joint measured(drives->tool.position);
    // With power but not enabled it keeps its set-point, because otherwise noise and load would
    // make it drift.
    const bool keeps = arm_.powered() && wasHeard && !rests && !paused && !unpowered;
    if (begins) {
      setpoint_.beginAnew(measured, now);
    } else if (!keeps) {
      setpoint_.rest(measured);
    }
  }
  advance(dt);
  if (setpoint_.step(now)) {
    endMove(true);
    hold();
  }
  publish(now);
}

void JawController::take(const DriveReading<6>& drives) {
  measuredJs_.position[0] = drives.tool.position;
  measuredJs_.velocity[0] = drives.tool.velocity;
  measuredJs_.effort[0] = drives.tool.effort;
  measuredJs_.stamp = drives.stamp;
}

void JawController::advance(double dt) {
  const double most = model_.rate_limit * dt;
  switch (activity_) {
    case Activity::Holding:
    case Activity::Moving: break;
    case Activity::Following: approach(goal_, most); break;
    case Activity::Pushing:
      approach(effort_ < 0 ? model_.lower : model_.upper,
               most * std::abs(effort_) / model_.effort_limit);
      break;
  }
}

void JawController::approach(double goal, double most) {
  setpoint_.put(Joint(setpoint() + std::clamp(goal - setpoint(), -most, most)));
}

void JawController::publish(suture::Time now) {
  setpointJs_.position[0] = setpoint();
  setpointJs_.effort[0] = effort_;
  setpointJs_.stamp = now;
  setpointJs_.valid = measuredJs_.stamp != suture::Time{};
}

}  // namespace robots
