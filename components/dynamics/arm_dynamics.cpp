#include "dynamics/arm_dynamics.h"

#include <Eigen/Cholesky>

namespace robots::dynamics {

using Eigen::Isometry3d;
using Eigen::Vector3d;

template <int N>
ArmDynamics<N>::ArmDynamics(const kinematics::Chain<N>& chain, const Links& links,
                            const Vector3d& gravity)
    : chain_(chain), gravity_(gravity) {
  for (int i = 0; i < N; ++i) {
    const auto link = static_cast<std::size_t>(i);
    bodies_[link] = aboutOrigin(links[link]);
    screws_[link] = chain.screw(i);
    rotors_[i] = links[link].rotor;
  }
}

template <int N>
typename ArmDynamics<N>::Posture ArmDynamics<N>::at(const Joints& q) const {
  Posture posture;
  for (int i = 0; i < N; ++i) posture[static_cast<std::size_t>(i)] = chain_.relative(i, q[i]);
  return posture;
}

template <int N>
typename ArmDynamics<N>::Joints ArmDynamics<N>::inverse(const Posture& posture,
                                                        const Joints& velocity,
                                                        const Joints& acceleration) const {
  // A base that accelerates upwards acts on its links as gravity does.
  SpatialVector twist = SpatialVector::Zero(), change = SpatialVector::Zero();
  change.head<3>() = -gravity_;
  std::array<SpatialVector, std::size_t{N}> wrenches;
  for (int i = 0; i < N; ++i) {
    const auto link = static_cast<std::size_t>(i);
    const SpatialVector& screw = screws_[link];
    const SpatialVector own = screw * velocity[i];
    twist = twistAt(posture[link], twist) + own;
    change = twistAt(posture[link], change) + screw * acceleration[i] + crossMotion(twist, own);
    wrenches[link] =
        momentum(bodies_[link], change) + crossForce(twist, momentum(bodies_[link], twist));
  }
  Joints effort;
  for (int i = N - 1; i >= 0; --i) {
    const auto link = static_cast<std::size_t>(i);
    effort[i] = screws_[link].dot(wrenches[link]) + rotors_[i] * acceleration[i];
    if (i > 0) wrenches[link - 1] += wrenchFrom(posture[link], wrenches[link]);
  }
  return effort;
}

template <int N>
typename ArmDynamics<N>::Joints ArmDynamics<N>::gravity(const Posture& posture) const {
  return inverse(posture, Joints::Zero(), Joints::Zero());
}

template <int N>
typename ArmDynamics<N>::Inertia ArmDynamics<N>::inertia(const Posture& posture) const {
  Inertia inertia;
  BodyInertia outward;  // this link and all behind it
  for (int i = N - 1; i >= 0; --i) {
    const auto link = static_cast<std::size_t>(i);
    outward = bodies_[link] + outward;
    SpatialVector wrench = momentum(outward, screws_[link]);
    inertia(i, i) = screws_[link].dot(wrench) + rotors_[i];
    for (int j = i - 1; j >= 0; --j) {
      const auto inner = static_cast<std::size_t>(j);
      wrench = wrenchFrom(posture[inner + 1], wrench);
      inertia(i, j) = inertia(j, i) = screws_[inner].dot(wrench);
    }
    outward = movedTo(posture[link], outward);
  }
  return inertia;
}

template <int N>
typename ArmDynamics<N>::Joints ArmDynamics<N>::forward(const Posture& posture,
                                                        const Joints& velocity,
                                                        const Joints& effort) const {
  const Joints left = effort - inverse(posture, velocity, Joints::Zero());
  return inertia(posture).llt().solve(left);
}

template <int N>
double ArmDynamics<N>::kineticEnergy(const Posture& posture, const Joints& velocity) const {
  return velocity.dot(inertia(posture) * velocity) / 2;
}

template <int N>
double ArmDynamics<N>::potentialEnergy(const Posture& posture) const {
  BodyInertia outward;
  for (std::size_t link = std::size_t{N}; link-- > 0;) {
    outward = movedTo(posture[link], bodies_[link] + outward);
  }
  return -gravity_.dot(outward.moment);
}

template class ArmDynamics<6>;
template class ArmDynamics<7>;

}  // namespace robots::dynamics
