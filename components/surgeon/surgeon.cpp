#include "surgeon/surgeon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surgeon/pause.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kFingerRate = 2;  // rad/s, beyond what the path asks for at its default shape

}  // namespace

Surgeon::Surgeon(const SurgeonParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      shape_{parameters.amplitude, parameters.turn, parameters.frequency, parameters.ramp},
      opening_(parameters.opening) {
  teleoperation_.on().teleop_state(
      [this](const TeleopState& state) { follows_ = state == TeleopState::Following; });
}

/// Returns false while the master is being aligned, because moving it would work against that.
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
  squeeze(t);
}

/// Opens and closes the fingers as the hand swings. They come there evenly, because the path may
/// have begun anew while they were open.
void Surgeon::squeeze(double t) {
  const double wanted = opening_ * (1 - std::cos(2 * std::numbers::pi * shape_.frequency * t)) / 2;
  const double most = kFingerRate * inSeconds(period());
  opened_ += std::clamp(wanted - opened_, -most, most);
  (void)hand_.squeeze(opened_);
}

}  // namespace robots
