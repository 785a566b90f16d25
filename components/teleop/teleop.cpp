#include "teleop/teleop.h"

#include <suture/base/errors.h>

#include <string>
#include <utility>

namespace robots {
namespace {

double requireValidScale(double scale) {
  if (FollowLaw::isValidScale(scale)) return scale;
  throw suture::SetupError("teleoperation with scale " + std::to_string(scale),
                           "a slave can only follow with a finite scale above zero",
                           "set \"scale\" to slave metres a master metre, e.g. 0.2");
}

}  // namespace

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
  const PoseStamped* master = usable(masterSample);
  const PoseStamped* slave = usable(slaveSample);
  if (master == nullptr || slave == nullptr || isOld(*master) || !masterWatch_.ready() ||
      !slaveWatch_.ready()) {
    return leave();
  }
  if (slaveWatch_.hasBrokenOff()) law_.reset();
  if (!law_) begin(*master, *slave);
  // The goal keeps the stamp of the master's data, so its age is known wherever it arrives.
  if (!slave_.servo_cp({law_->follow(master->pose), master->stamp, true})) leave();
}

const PoseStamped* Teleop::usable(const suture::Sample<PoseStamped>& sample) const {
  return sample && sample.age() <= maxAge_ && sample->valid ? &*sample : nullptr;
}

bool Teleop::isOld(const PoseStamped& master) const {
  return suture::now() - master.stamp > maxAge_;
}

void Teleop::begin(const PoseStamped& master, const PoseStamped& slaveSetpoint) {
  law_.emplace(master.pose, slaveSetpoint.pose, scale_);
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
