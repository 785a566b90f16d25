#pragma once
// This says how simulated joints follow their set-point: late, at a bounded rate, within limits.

#include <algorithm>
#include <cmath>

#include "drives/simulated_joints.h"
#include "parameters/parameter_check.h"

namespace robots {

/// A LaggingJoint is one joint: d(measured)/dt = (setpoint - measured) / time_constant, cut to
/// +-rate_limit. It is solved exactly over each interval for a constant set-point, so the result
/// does not depend on the period: a step of 2 ms equals two steps of 1 ms.
struct LaggingJoint {
  double time_constant;  ///< s, > 0
  double rate_limit;     ///< rad/s or m/s, > 0

  /// Returns the velocity in rad/s or m/s.
  double velocity(double measured, double setpoint) const {
    return std::clamp((setpoint - measured) / time_constant, -rate_limit, rate_limit);
  }

  /// Returns the position of the joint `dt` seconds later.
  double after(double dt, double measured, double setpoint) const {
    const double error = setpoint - measured;
    // The rate limit holds while the error exceeds what the lag alone would drive at that rate.
    const double saturated =
        std::clamp((std::abs(error) - rate_limit * time_constant) / rate_limit, 0.0, dt);
    const double reached = measured + std::copysign(rate_limit * saturated, error);
    return setpoint + (reached - setpoint) * std::exp(-(dt - saturated) / time_constant);
  }
};

/// One thread; only the constructor throws or allocates. Holds N joints with one time constant and
/// a rate limit for each. Set-points are cut to the position limits.
template <int N>
class JointDynamics final : public SimulatedJoints<N> {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  /// The joints rest at `start`. Rates are in rad/s or m/s, limits in rad or m, the time constant
  /// in s. Throws std::invalid_argument unless time constant and rates are positive.
  JointDynamics(double timeConstant, const Joints& rateLimit, const Joints& lower,
                const Joints& upper, const Joints& start)
      : timeConstant_(timeConstant),
        rateLimit_(rateLimit),
        lower_(lower),
        upper_(upper),
        measured_(cut(start)),
        setpoint_(measured_) {
    ParameterCheck("joints that trail their goals")
        .isPositive("time constant in s", timeConstant)
        .arePositive("rate limit of a joint", rateLimit);
  }

  void command(const Joints& setpoint) override { setpoint_ = cut(setpoint); }
  void brake() override { setpoint_ = measured_; }

  void advance(double dt) override {
    for (int i = 0; i < N; ++i) measured_[i] = joint(i).after(dt, measured_[i], setpoint_[i]);
  }

  const Joints& measured() const override { return measured_; }
  const Joints& setpoint() const { return setpoint_; }
  Joints velocity() const override {
    Joints velocity;
    for (int i = 0; i < N; ++i) velocity[i] = joint(i).velocity(measured_[i], setpoint_[i]);
    return velocity;
  }

 private:
  LaggingJoint joint(int i) const { return {timeConstant_, rateLimit_[i]}; }
  Joints cut(const Joints& q) const { return q.cwiseMax(lower_).cwiseMin(upper_); }

  double timeConstant_;
  Joints rateLimit_, lower_, upper_;
  Joints measured_, setpoint_;
};

}  // namespace robots
