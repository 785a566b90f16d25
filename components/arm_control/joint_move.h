#pragma once
// A planned joint motion from rest to rest.

#include <Eigen/Core>
#include <algorithm>

#include "arm_control/smooth_step.h"

namespace robots {

/// All joints start and stop together, along a minimum-jerk profile, none faster than half of its
/// rate limit. Immutable; allocates nothing.
template <int N>
class JointMove {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// rad, or m for a prismatic joint; rate limits per second.
  JointMove(const Joints& from, const Joints& to, const Joints& rateLimit) : from_(from), to_(to) {
    const double slowest = (to - from).cwiseAbs().cwiseQuotient(0.5 * rateLimit).maxCoeff();
    duration_ = std::max(kShortest, kSmoothStepPeakSlope * slowest);
  }

  /// Where the joints shall be `t` seconds after the start.
  Joints at(double t) const { return from_ + smoothStep(t / duration_) * (to_ - from_); }
  /// s
  double duration() const { return duration_; }

 private:
  static constexpr double kShortest = 0.05;  // s

  Joints from_, to_;
  double duration_;
};

}  // namespace robots
