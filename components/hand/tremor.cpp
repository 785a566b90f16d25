#include "hand/tremor.h"

#include <cmath>
#include <numbers>
#include <random>

namespace robots {

Tremor::Tremor(const TremorModel& model)
    : height_(model.amplitude / std::numbers::sqrt3 * std::sqrt(2.0 / kSines)) {
  constexpr double kTurn = 2 * std::numbers::pi;
  std::mt19937 random(model.seed);
  std::uniform_real_distribution<double> share;
  for (auto& axis : axes_) {
    // There is one sine in each part of the band, so that they never add up to a tone.
    for (std::size_t i = 0; i < kSines; ++i) {
      const double place = (static_cast<double>(i) + share(random)) / kSines;
      axis[i].frequency = kTurn * (kLowest + place * (kHighest - kLowest));
      axis[i].phase = kTurn * share(random);
    }
  }
}

Tremor::Motion Tremor::at(double t) const {
  Motion motion{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (int axis = 0; axis < 3; ++axis) {
    for (const Sine& sine : axes_[static_cast<std::size_t>(axis)]) {
      const double offset = height_ * std::sin(sine.frequency * t + sine.phase);
      motion.offset[axis] += offset;
      motion.velocity[axis] += height_ * sine.frequency * std::cos(sine.frequency * t + sine.phase);
      motion.acceleration[axis] -= sine.frequency * sine.frequency * offset;
    }
  }
  return motion;
}

}  // namespace robots
