#pragma once
// This keeps rates from changing faster than they may.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace robots {

/// One thread; never allocates. Holds one rate for each joint or axis.
template <int Size>
class RateRamp {
 public:
  using Rates = Eigen::Matrix<double, Size, 1>;

  /// Bounds how much a rate may change in a second, away from zero and towards it. If a bound is
  /// infinite, the rate changes at once.
  struct Limits {
    Rates acceleration = Rates::Constant(std::numeric_limits<double>::infinity());
    Rates deceleration = Rates::Constant(std::numeric_limits<double>::infinity());
  };

  void aimAt(const Rates& target, const Limits& limits) {
    target_ = target;
    limits_ = limits;
  }
  /// Makes all rates zero at once.
  void stop() { present_ = target_ = Rates::Zero(); }

  const Rates& present() const { return present_; }
  /// Returns the rates `dt` seconds later.
  const Rates& advance(double dt) {
    for (int i = 0; i < Size; ++i) {
      present_[i] =
          next(present_[i], target_[i], limits_.acceleration[i], limits_.deceleration[i], dt);
    }
    return present_;
  }

 private:
  // A rate that changes its sign slows down to zero first.
  static double next(double present, double target, double acceleration, double deceleration,
                     double dt) {
    const bool turns = present * target < 0;
    const bool slows = turns || std::abs(target) < std::abs(present);
    const double limit = slows ? deceleration : acceleration;
    if (!std::isfinite(limit)) {
      return turns ? next(0, target, acceleration, deceleration, dt) : target;
    }
    const double aim = turns ? 0 : target;
    return present + std::clamp(aim - present, -limit * dt, limit * dt);
  }

  Rates present_ = Rates::Zero(), target_ = Rates::Zero();
  Limits limits_;
};

}  // namespace robots
