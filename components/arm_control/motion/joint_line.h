#pragma once
// This is a straight line of the joints, for goals that come more slowly than the arm's cycles.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <algorithm>

#include "timing/seconds.h"

namespace robots {

/// Immutable; never allocates. All joints begin and arrive together, each at a constant rate.
template <int N>
class JointLine {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// Takes `wanted` seconds from `begin` on, or longer if a joint needs that at its rate limit.
  /// Joints are in rad, or m for a prismatic one; rate limits are per second.
  JointLine(const Joints& from, const Joints& to, const Joints& rateLimit, suture::Time begin,
            double wanted)
      : from_(from),
        to_(to),
        begin_(begin),
        wanted_(wanted),
        duration_(std::max(wanted, (to - from).cwiseAbs().cwiseQuotient(rateLimit).maxCoeff())) {}

  const Joints& to() const { return to_; }
  suture::Time begin() const { return begin_; }
  double wanted() const { return wanted_; }
  /// Returns where the joints shall be at `now`, which must not be before the beginning.
  Joints at(suture::Time now) const {
    const double t = secondsBetween(begin_, now);
    return t >= duration_ ? to_ : Joints(from_ + t / duration_ * (to_ - from_));
  }

 private:
  Joints from_, to_;
  suture::Time begin_;
  double wanted_, duration_;
};

}  // namespace robots
