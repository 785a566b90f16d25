#include "surgeon/surgeon.h"

#include <cmath>
#include <numbers>

#include "surgeon/pause.h"
#include "timing/seconds.h"

namespace robots {

Surgeon::Surgeon(const SurgeonParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      shape_{parameters.amplitude, parameters.turn, parameters.frequency, parameters.ramp},
      opening_(parameters.opening) {
  teleoperation_.on().teleop_state(
      [this](const TeleopState& state) { follows_ = state == TeleopState::Following; });
}

/// Whoever moves a master that is being aligned fights with it.
bool Surgeon::mayMove() {
  const bool followed = teleoperation_.isAbsent() || (teleoperation_.connected() && follows_);
  return followed && watch_.ready() && master_.connected();
}

void Surgeon::run() {
  const suture::Time now = suture::now();
  if (!mayMove()) return path_.reset();
  const bool missed = cycles_.missed(kLongestPause);
  if (watch_.hasBrokenOff() || missed) path_.reset();
  if (!path_) {
    const auto start = master_.setpoint_cp();
    if (!start || !start->valid) return;
    if (!centre_) centre_ = start->pose;
    path_.emplace(start->pose, *centre_, shape_);
    setOut_ = now;
  }
  const double t = secondsBetween(setOut_, now);
  if (!master_.servo_cp({path_->at(t), now, true})) return path_.reset();
  const double open = (1 - std::cos(2 * std::numbers::pi * shape_.frequency * t)) / 2;
  (void)hand_.squeeze(opening_ * open);
}

}  // namespace robots
