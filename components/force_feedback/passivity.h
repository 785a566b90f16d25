#pragma once
// This keeps a force feedback from giving more energy than it was given.

#include <Eigen/Core>

namespace robots {

/// One thread; never allocates. A PassivityObserver is the time-domain passivity observer
/// (Hannaford and Ryu, "Time-domain passivity control of haptic interfaces", 2002) of the port at
/// which a hand holds a master, along each axis by itself. Motors hold their force from one cycle
/// to the next, so the work of a force is that force times the way in between, without an error
/// (Stramigioli et al., "Sampled data systems passivity and discrete port-Hamiltonian systems",
/// 2005).
///
/// Positions are in m in one frame, forces in N along its axes.
class PassivityObserver {
 public:
  /// Begins the account with the hand at `position`, where nothing pushes it.
  void beginAt(const Eigen::Vector3d& position) {
    position_ = position;
    force_ = energy_ = Eigen::Vector3d::Zero();
  }
  /// Call this in each cycle, before the force changes, with the position to which the hand has
  /// come.
  void movedTo(const Eigen::Vector3d& position) {
    energy_ -= force_.cwiseProduct(position - position_);
    position_ = position;
  }
  /// Forgets what the account has beyond `energy` (J) along each axis. Friction takes what the hand
  /// gives for good, so that the feedback must not give it back a minute later.
  void keepAtMost(const Eigen::Vector3d& energy) { energy_ = energy_.cwiseMin(energy); }
  /// Says that `force` pushes the hand from now on.
  void pushes(const Eigen::Vector3d& force) { force_ = force; }

  /// Returns the energy in J that the hand has given along each axis since the account began, less
  /// what was forgotten. Below zero the feedback has given more than it was given: it is active.
  const Eigen::Vector3d& energy() const { return energy_; }

 private:
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(), force_ = Eigen::Vector3d::Zero(),
                  energy_ = Eigen::Vector3d::Zero();
};

/// Acts as the passivity controller of the same paper, in series with the feedback. `force` is
/// about to push a hand that moves with `velocity` (m/s) for `dt` seconds (> 0). Returns that force
/// and as much damping as takes what `energy` would lack after that, along each axis by itself. It
/// brakes a hand by no more than `most`, in N.s/m, because more than the moving mass divided by dt
/// would throw the hand back; what then still lacks is left to the next cycle.
Eigen::Vector3d damped(const Eigen::Vector3d& force, const Eigen::Vector3d& velocity,
                       const Eigen::Vector3d& energy, double most, double dt);

}  // namespace robots
