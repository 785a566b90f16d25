#pragma once
// This says how the joints of an arm move under efforts: by its equations of motion, friction and
// stops, in time.

#include "dynamics/arm_dynamics.h"

namespace robots::dynamics {

/// Holds what acts at the joints beside their efforts. Vectors are in the units of the joints.
template <int N>
struct JointSurroundings {
  using Joints = typename ArmDynamics<N>::Joints;

  Joints viscous;       ///< effort per unit of velocity
  Joints coulomb;       ///< effort
  Joints lower, upper;  ///< the mechanical stops, which are inelastic
};

/// One thread; never allocates. It is deterministic: equal starts, efforts and times give equal
/// motion.
///
/// Integrates in steps of at most kStep: half a step of position, a step of velocity with the
/// forces at its middle, and again half a step of position. So the error is of second order, and a
/// joint that stands still does not creep. Viscous friction acts by the new velocity. Coulomb
/// friction and the stops are impulses that would bring each joint to rest, within what friction
/// gives (projected Gauss-Seidel iterations, bounded).
template <int N>
class JointMotion {
 public:
  using Joints = typename ArmDynamics<N>::Joints;

  static constexpr double kStep = 1.0 / 3000;  ///< s
  /// Bounds the steps of one call, so that a late call does not take longer and longer; the joints
  /// lose the time beyond.
  static constexpr int kMostSteps = 30;

  /// The joints rest at `start`.
  JointMotion(const ArmDynamics<N>& dynamics, const JointSurroundings<N>& surroundings,
              const Joints& start);

  /// Lets `dt` seconds (>= 0) pass under constant efforts.
  void advance(double dt, const Joints& effort);
  /// Makes the joints stand still, as if brakes had caught them.
  void halt();

  const ArmDynamics<N>& dynamics() const { return dynamics_; }
  const Joints& position() const { return position_; }
  const Joints& velocity() const { return velocity_; }

 private:
  using Inertia = typename ArmDynamics<N>::Inertia;

  void step(double h, const Joints& effort);
  /// Adds to the velocity what friction and stops do within `h`. `mobility` is the velocity that an
  /// impulse causes.
  void applyFrictionAndStops(double h, const Inertia& mobility);

  ArmDynamics<N> dynamics_;
  JointSurroundings<N> surroundings_;
  Joints position_, velocity_;
  Joints friction_ = Joints::Zero();  // effort of the last step, at which the iterations begin
};

extern template class JointMotion<6>;
extern template class JointMotion<7>;

}  // namespace robots::dynamics
