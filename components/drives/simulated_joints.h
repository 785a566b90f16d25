#pragma once
// What simulated drives do with simulated joints, whatever moves those.

#include <Eigen/Core>

namespace robots {

/// N joints and what drives each of them. Vectors are in rad, or m of a prismatic joint. Confined
/// to one thread; no method allocates.
template <int N>
class SimulatedJoints {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  virtual ~SimulatedJoints() = default;

  /// Lets `dt` seconds (>= 0) pass.
  virtual void advance(double dt) = 0;
  /// The joints have power, and shall be there from now on.
  virtual void command(const Joints& setpoint) = 0;
  /// The joints have no power, and brakes, if they have any, hold them where they are.
  virtual void brake() = 0;

  virtual const Joints& measured() const = 0;
  virtual Joints velocity() const = 0;
  /// What the motors give, N.m, or N of a prismatic joint; 0 of joints without mass.
  virtual Joints effort() const { return Joints::Zero(); }
  /// Whether that is what moves them.
  virtual bool measuresEffort() const { return false; }
};

}  // namespace robots
