#pragma once
// This computes how fast something moves from where it is at different times.

#include <Eigen/Core>

namespace robots {

/// Belongs to its task's thread; never allocates. Divides the difference of two positions by the
/// time between them, and passes it through a low-pass filter of first order, because a step of one
/// encoder count alone would be a large velocity. So the result is late by the time constant.
template <int N>
class RateFilter {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// `timeConstant` is in s, >= 0.
  explicit RateFilter(double timeConstant) : timeConstant_(timeConstant) {}

  /// Says that it rests at `position`.
  void reset(const Joints& position) {
    last_ = position;
    rate_.setZero();
  }

  /// Says that it is at `position` `dt` seconds (> 0) later.
  void update(const Joints& position, double dt) {
    rate_ += dt / (timeConstant_ + dt) * ((position - last_) / dt - rate_);
    rate_ = (rate_.array().abs() < kRest).select(0, rate_);
    last_ = position;
  }

  const Joints& rate() const { return rate_; }

 private:
  // Smaller rates are cut to 0, because a rate that fades for ever becomes a denormal number, with
  // which processors are slow.
  static constexpr double kRest = 1e-12;

  double timeConstant_;
  Joints last_ = Joints::Zero(), rate_ = Joints::Zero();
};

}  // namespace robots
