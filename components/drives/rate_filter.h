#pragma once
// How fast something moves, told from where it is now and then.

#include <Eigen/Core>

namespace robots {

/// The difference of two positions by the time between them, through a low-pass filter of first
/// order: a step of one encoder count alone would be a large velocity. So it is late by the time
/// constant. A value type of its task's thread; never allocates.
template <int N>
class RateFilter {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// `timeConstant` in s, >= 0.
  explicit RateFilter(double timeConstant) : timeConstant_(timeConstant) {}

  /// It rests at `position`.
  void reset(const Joints& position) {
    last_ = position;
    rate_.setZero();
  }

  /// `dt` seconds (> 0) later it is at `position`.
  void update(const Joints& position, double dt) {
    rate_ += dt / (timeConstant_ + dt) * ((position - last_) / dt - rate_);
    rate_ = (rate_.array().abs() < kRest).select(0, rate_);
    last_ = position;
  }

  const Joints& rate() const { return rate_; }

 private:
  // What fades for ever becomes numbers that processors are slow with.
  static constexpr double kRest = 1e-12;

  double timeConstant_;
  Joints last_ = Joints::Zero(), rate_ = Joints::Zero();
};

}  // namespace robots
