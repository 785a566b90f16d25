#pragma once
// These are the equations of motion of a serial arm of rigid bodies.

#include <array>
#include <cstddef>

#include "dynamics/rigid_body.h"
#include "kinematics/chain.h"

namespace robots::dynamics {

/// Gravity accelerates masses by this, in m/s^2, where the z of the base frame points upwards.
inline const Eigen::Vector3d kEarthGravity{0, 0, -9.80665};

/// Any thread, because it is immutable; no method allocates. The equation is effort = inertia(q) *
/// acceleration + inverse(q, velocity, 0). Efforts are in N.m, or N for a prismatic joint.
///
/// The algorithms are the recursive Newton-Euler one and that of composite rigid bodies
/// (Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapters 5 and 6).
template <int N>
class ArmDynamics {
 public:
  using Joints = typename kinematics::Chain<N>::Joints;
  using Inertia = Eigen::Matrix<double, N, N>;
  using Links = std::array<LinkInertia, std::size_t{N}>;
  /// Holds each link's frame in that of the link before. It is computed once for all that is asked
  /// of one joint vector.
  using Posture = std::array<Eigen::Isometry3d, std::size_t{N}>;

  /// `gravity` is in the arm's base frame, m/s^2.
  ArmDynamics(const kinematics::Chain<N>& chain, const Links& links,
              const Eigen::Vector3d& gravity = kEarthGravity);

  const kinematics::Chain<N>& chain() const { return chain_; }
  Posture at(const Joints& q) const;

  /// Returns the efforts that an acceleration takes, against gravity and the effects of velocities.
  Joints inverse(const Posture& posture, const Joints& velocity, const Joints& acceleration) const;
  /// Returns the efforts that hold the arm against gravity.
  Joints gravity(const Posture& posture) const;
  /// Returns the joint-space inertia matrix, including the rotors.
  Inertia inertia(const Posture& posture) const;
  /// Returns the acceleration that efforts cause.
  Joints forward(const Posture& posture, const Joints& velocity, const Joints& effort) const;

  double kineticEnergy(const Posture& posture, const Joints& velocity) const;  ///< J
  /// Returns the potential energy in J; it is 0 where every centre of mass is at the height of the
  /// base frame's origin.
  double potentialEnergy(const Posture& posture) const;

 private:
  kinematics::Chain<N> chain_;
  std::array<BodyInertia, std::size_t{N}> bodies_;
  std::array<SpatialVector, std::size_t{N}> screws_;
  Joints rotors_;
  Eigen::Vector3d gravity_;
};

extern template class ArmDynamics<6>;
extern template class ArmDynamics<7>;

}  // namespace robots::dynamics
