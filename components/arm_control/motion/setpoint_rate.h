#pragma once
// This computes how fast a set-point moves, whatever moves it.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <utility>

#include "timing/seconds.h"

namespace robots {

/// One thread; never allocates. Looks at the set-point in each cycle. Goals may come more slowly
/// than cycles, so the velocity is that between the last two changes, until no change has come for
/// twice the time between those. A joint whose set-point jumped has no velocity, and neither has
/// one that has moved only once since it rested.
template <int N>
class SetpointRate {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// `limit` is per second; a faster change is a jump.
  explicit SetpointRate(const Joints& limit) : limit_(limit) {}

  /// Call this once a cycle.
  void update(suture::Time now, const Joints& setpoint) {
    const suture::Duration since = now - changed_;
    if (setpoint == last_) {
      if (since > 2 * interval_) rest(setpoint);
      return;
    }
    if (since <= suture::Duration{0}) return;
    if (!std::exchange(rested_, false)) {
      rate_ = (setpoint - last_) / inSeconds(since);
      rate_ = (rate_.array().abs() <= kTolerance * limit_.array()).select(rate_, 0);
    }
    interval_ = since;
    changed_ = now;
    last_ = setpoint;
  }
  /// Says that the set-point has been stopped there.
  void rest(const Joints& setpoint) {
    rate_.setZero();
    last_ = setpoint;
    rested_ = true;
  }

  /// Returns the velocity per second, within the limit.
  Joints rate() const { return rate_.cwiseMin(limit_).cwiseMax(-limit_); }

 private:
  static constexpr double kTolerance = 1.001;  // for the rounding of what moves at the limit

  const Joints limit_;
  Joints last_ = Joints::Zero(), rate_ = Joints::Zero();
  suture::Time changed_;
  suture::Duration interval_{0};  // between the last two changes
  bool rested_ = true;            // there has been no change since
};

}  // namespace robots
