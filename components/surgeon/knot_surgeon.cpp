#include "surgeon/knot_surgeon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "arm_control/motion/smooth_step.h"
#include "surgeon/pause.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kFade = 2;  // s

}  // namespace

KnotSurgeon::KnotSurgeon(const KnotSurgeonParameters& parameters)
    : PeriodicTask({.period = parameters.period}), parameters_(parameters) {
  guidance_.on().guidance_state(
      [this](const GuidanceState& state) { guided_ = state == GuidanceState::Guiding; });
}

void KnotSurgeon::run() {
  if (!guided_ || !guidance_.connected() || !leftWatch_.ready() || !rightWatch_.ready()) {
    return interrupt();
  }
  const suture::Time now = suture::now();
  const bool missed = cycles_.missed(kLongestPause);
  if (leftWatch_.hasBrokenOff() || rightWatch_.hasBrokenOff() || missed) interrupt();
  if (!start_) {
    const auto left = left_.setpoint_cp(), right = right_.setpoint_cp();
    if (!left || !right || !left->valid || !right->valid) return;
    start_ = Start{left->pose, right->pose, now, now};
  }
  start_->moved = now;
  const Eigen::Translation3d offset(moved(secondsBetween(start_->at, now)));
  const bool leftTook = left_.servo_cp({offset * start_->left, now, true}).has_value();
  const bool rightTook = right_.servo_cp({offset * start_->right, now, true}).has_value();
  if (!leftTook || !rightTook) interrupt();
}

void KnotSurgeon::interrupt() {
  if (!start_) return;
  rest_ *= 1 - doneAfter(secondsBetween(start_->at, start_->moved));
  start_.reset();
}

/// Returns how much of the rest is done, from 0 to 1.
double KnotSurgeon::doneAfter(double t) const {
  return smoothStep(t / std::max(rest_ * parameters_.duration, 1e-3));
}

Eigen::Vector3d KnotSurgeon::moved(double t) const {
  const double done = doneAfter(t);
  // The sway fades in, so that it begins at rest.
  const double sway = smoothStep(t / kFade) * parameters_.sway *
                      std::sin(2 * std::numbers::pi * parameters_.sway_frequency * t);
  return done * rest_ * parameters_.carry + sway * Eigen::Vector3d(1, 0.5, 0);
}

}  // namespace robots
