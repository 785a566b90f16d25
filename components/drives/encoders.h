#pragma once
// This simulates what encoders measure of joints.

#include <cstdint>
#include <random>

#include "drives/coupling.h"
#include "drives/rate_filter.h"

namespace robots {

template <int N>
struct EncoderModel {
  using Joints = Eigen::Matrix<double, N, 1>;

  Joints step;               ///< rad or m: one count, of an actuator
  bool quantisation = true;  ///< they read whole counts
  double noise = 0;          ///< counts: the standard deviation of what they add before that
  std::uint32_t seed = 1;
  double velocity_filter = 0.0;  ///< s: the time constant of velocities (rate_filter.h)
  Coupling<N> coupling = {};     ///< how actuators, which have the encoders, move the joints
};

/// One thread; never allocates. Equal seeds, positions and times give equal readings.
template <int N>
class Encoders {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  Encoders(const EncoderModel<N>& model, const Joints& start)
      : model_(model), random_(model.seed), rate_(model.velocity_filter), measured_(told(start)) {
    rate_.reset(measured_);
  }

  /// Reads the joints at `position`, `dt` seconds (> 0) after the last reading.
  void read(const Joints& position, double dt) {
    measured_ = told(position);
    rate_.update(measured_, dt);
  }

  const Joints& measured() const { return measured_; }
  const Joints& velocity() const { return rate_.rate(); }

 private:
  Joints told(const Joints& position) {
    Joints counts = model_.coupling.actuators(position).cwiseQuotient(model_.step);
    if (model_.noise > 0) {
      for (int i = 0; i < N; ++i) counts[i] += model_.noise * normal_(random_);
    }
    if (model_.quantisation) counts = counts.array().round();
    return model_.coupling.joints(counts.cwiseProduct(model_.step));
  }

  EncoderModel<N> model_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  RateFilter<N> rate_;
  Joints measured_;
};

}  // namespace robots
