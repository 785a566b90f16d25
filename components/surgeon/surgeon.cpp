#include "surgeon/surgeon.h"

#include <chrono>

namespace robots {

Surgeon::Surgeon(const SurgeonParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      shape_{parameters.amplitude, parameters.turn, parameters.frequency, parameters.ramp} {}

void Surgeon::run() {
  const suture::Time now = suture::now();
  if (!watch_.ready() || !master_.connected()) return path_.reset();
  if (!path_) {
    const auto start = master_.setpoint_cp();
    if (!start || !start->valid) return;
    path_.emplace(start->pose, shape_);
    setOut_ = now;
  }
  const double t = std::chrono::duration<double>(now - setOut_).count();
  if (!master_.servo_cp({path_->at(t), now, true})) path_.reset();
}

}  // namespace robots
