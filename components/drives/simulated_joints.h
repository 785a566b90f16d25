#pragma once
// This is what simulated drives do with simulated joints, whatever moves those.

#include <Eigen/Core>

#include "drives/motor_order.h"

namespace robots {

/// One thread; no method allocates. SimulatedJoints are N joints and what drives each of them.
/// Vectors are in rad, or m for a prismatic joint.
template <int N>
class SimulatedJoints {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  virtual ~SimulatedJoints() = default;

  /// At most this time passes in one cycle, in s, because drives that are late must not move their
  /// joints as far as the time that they missed would.
  static constexpr double kLongestStep = 0.01;

  /// Lets `dt` seconds pass, from 0 to kLongestStep.
  virtual void advance(double dt) = 0;
  /// Says that the joints have power, and where they shall be from now on.
  virtual void command(const Joints& setpoint) = 0;
  /// Says what the motors do besides following the set-point, from the next command on. It has no
  /// effect on joints without mass.
  virtual void order(const MotorOrder<N>& /*order*/) {}
  /// Says that the joints have no power; brakes, if they have any, hold them where they are.
  virtual void brake() = 0;

  virtual const Joints& measured() const = 0;
  virtual Joints velocity() const = 0;
  /// Returns what the motors give, in N.m, or N for a prismatic joint; 0 for joints without mass.
  virtual Joints effort() const { return Joints::Zero(); }
  /// Returns true if effort() is what moves the joints, so that order() has an effect.
  virtual bool measuresEffort() const { return false; }
};

}  // namespace robots
