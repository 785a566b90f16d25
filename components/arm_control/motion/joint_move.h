#pragma once
// This plans a joint motion to rest, from where the joints are and the velocity that they have.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "arm_control/motion/smooth_step.h"

namespace robots {

/// Says which share of the joints' limits a move may use.
struct MoveRatios {
  double velocity = 1, acceleration = 1;
};

/// Immutable; never allocates. All joints stop together. The motion of a joint is the sum of two:
/// it brakes at a constant rate from the velocity that it has, and it goes along a minimum-jerk
/// profile from where braking alone would stop it to its goal. Braking has half of the acceleration
/// limit, and the profile of a joint that brakes has at most the other half, so the sum keeps the
/// limit. No joint becomes faster than it was, or than half of its rate limit if that is more.
/// Braking takes at most half of the time. So a joint turns round at most once, and in the second
/// half it only comes nearer to its goal.
///
/// If a joint would pass its limit of position while it brakes like that, all joints brake first,
/// with the whole acceleration limit, and go along the profile after that. A joint that has too
/// little room even for this brakes as hard as it must, because it never passes its limit.
template <int N>
class JointMove {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// A Start is in rad, or in m for a prismatic joint.
  struct Start {
    Joints position;
    Joints velocity = Joints::Zero();  ///< per second
  };
  struct Limits {
    Joints rate;  ///< per second
    Joints acceleration = Joints::Constant(kUnlimited);
    Joints lower = Joints::Constant(-kUnlimited), upper = Joints::Constant(kUnlimited);
  };

  JointMove(const Start& start, const Joints& to, const Limits& limits,
            const MoveRatios& ratios = {})
      : from_(start.position), velocity_(start.velocity), to_(to) {
    planBraking(limits);
    way_ = to_ - from_ - 0.5 * velocity_.cwiseProduct(braking_);
    for (int i = 0; i < N; ++i) {
      const double way = std::abs(way_[i]);
      const bool brakesMeanwhile = velocity_[i] != 0 && brakesFirst_ == 0;
      const double share = brakesMeanwhile ? kShare : 1;
      const double acceleration = std::min(ratios.acceleration, share) * limits.acceleration[i];
      profile_ = std::max({profile_, brakesMeanwhile ? 2 * braking_[i] : 0,
                           kSmoothStepPeakSlope * way / (0.5 * ratios.velocity * limits.rate[i]),
                           std::sqrt(kSmoothStepPeakCurvature * way / acceleration)});
    }
  }

  /// Returns where the joints shall be `t` seconds after the start.
  Joints at(double t) const {
    if (t >= duration()) return to_;
    Joints q = from_ + smoothStep((t - brakesFirst_) / profile_) * way_;
    for (int i = 0; i < N; ++i) q[i] += braked(i, t);
    return q;
  }
  const Joints& to() const { return to_; }
  /// Returns how long the move takes, in s.
  double duration() const { return brakesFirst_ + profile_; }

 private:
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  static constexpr double kShortest = 0.05;  // s
  static constexpr double kShare = 0.5;      // braking takes so much of the acceleration

  /// Decides how long each joint brakes, and if all of them do so before they go to the goal.
  void planBraking(const Limits& limits) {
    const Joints speed = velocity_.cwiseAbs();
    const Joints most = longestBraking(limits);
    braking_ = speed.cwiseQuotient(kShare * limits.acceleration);
    if ((braking_.array() <= most.array()).all()) return;
    braking_ = speed.cwiseQuotient(limits.acceleration).cwiseMin(most);
    brakesFirst_ = braking_.maxCoeff();
  }
  /// Returns in what time each joint must stop, at a constant rate, to stay within its limits.
  Joints longestBraking(const Limits& limits) const {
    Joints most = Joints::Constant(kUnlimited);
    for (int i = 0; i < N; ++i) {
      if (velocity_[i] == 0) continue;
      const double limit = velocity_[i] > 0 ? limits.upper[i] : limits.lower[i];
      most[i] = std::max(2 * (limit - from_[i]) / velocity_[i], 0.0);
    }
    return most;
  }
  /// Returns how far the joint has gone by its first velocity while it brakes.
  double braked(int joint, double t) const {
    const double whole = braking_[joint];
    if (whole <= 0) return 0;
    const double s = std::min(t, whole);
    return velocity_[joint] * s * (1 - 0.5 * s / whole);
  }

  Joints from_, velocity_, to_;
  Joints braking_;              // s: how long each brakes
  Joints way_;                  // how far the profile leads
  double brakesFirst_ = 0;      // s: the profile begins then
  double profile_ = kShortest;  // s: how long that takes
};

}  // namespace robots
