#include "teleop/teleop.h"

#include <algorithm>
#include <utility>

#include "arm/fresh_pose.h"
#include "teleop/valid_scale.h"

namespace robots {

Teleop::Teleop(const TeleopParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      scale_(requireValidScale(parameters.scale)),
      maxAge_(parameters.max_age),
      enableAtFirstCycle_(parameters.enable_at_start) {}

void Teleop::enable() {
  masterWatch_.permit();
  slaveWatch_.permit();
  if (state_ == TeleopState::Disabled) enter(TeleopState::Preparing);
}

void Teleop::disable() {
  law_.reset();
  enter(TeleopState::Disabled);
}

void Teleop::run() {
  if (std::exchange(enableAtFirstCycle_, false)) enable();
  if (state_ == TeleopState::Disabled) return;
  masterWatch_.prepare();
  slaveWatch_.prepare();

  const auto masterSample = master_.measured_cp();
  const auto slaveSample = slave_.setpoint_cp();
  const PoseStamped* const master = freshMeasurement(masterSample, maxAge_);
  const PoseStamped* const slave = freshPose(slaveSample, maxAge_);
  if (master == nullptr || slave == nullptr || !masterWatch_.ready() || !slaveWatch_.ready()) {
    return leave();
  }
  const bool missed = cycles_.missed(std::max(maxAge_, 3 * period()));
  if (slaveWatch_.hasBrokenOff() || missed) law_.reset();
  const bool begins = !law_;
  if (begins) law_.emplace(master->pose, slave->pose, scale_);
  // The goal keeps the stamp of the master's data, so its age is known wherever it arrives.
  if (!slave_.servo_cp({law_->follow(master->pose), master->stamp, true})) return leave();
  if (begins) announce(*master, *slave);
}

/// It follows: the slave has taken its first goal.
void Teleop::announce(const PoseStamped& master, const PoseStamped& slaveSetpoint) {
  anchors_ = {master.stamp, master.pose, slaveSetpoint.pose, scale_, anchors_.entry + 1};
  enter(TeleopState::Following);
  teleoperation_.emit().followed(anchors_);
}

void Teleop::leave() {
  law_.reset();
  enter(TeleopState::Preparing);
}

void Teleop::enter(TeleopState state) {
  if (state_ == state) return;
  state_ = state;
  teleoperation_.emit().teleop_state(state);
}

}  // namespace robots
