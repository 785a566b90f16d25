#pragma once
// What keeps a force feedback from giving more energy than it was given.

#include <Eigen/Core>

namespace robots {

/// The time-domain passivity observer (Hannaford and Ryu, "Time-domain passivity control of haptic
/// interfaces", 2002) of the port at which a hand holds a master, along each axis by itself. Motors
/// hold their force from one cycle to the next, so what it does is that force by the way in
/// between, without an error (Stramigioli et al., "Sampled data systems passivity and discrete
/// port-Hamiltonian systems", 2005).
///
/// Positions are in m in one frame, forces in N along its axes. Confined to one thread; never
/// allocates.
class PassivityObserver {
 public:
  /// The account begins with the hand at `position`, and nothing pushes it.
  void beginAt(const Eigen::Vector3d& position) {
    position_ = position;
    force_ = energy_ = Eigen::Vector3d::Zero();
  }
  /// Each cycle, before the force changes: the hand has come to `position`.
  void movedTo(const Eigen::Vector3d& position) {
    energy_ -= force_.cwiseProduct(position - position_);
    position_ = position;
  }
  /// From now on `force` pushes the hand.
  void pushes(const Eigen::Vector3d& force) { force_ = force; }

  /// J: what the hand has given along each axis since the account began. Below zero the feedback
  /// has given more than it was given: it is active.
  const Eigen::Vector3d& energy() const { return energy_; }

 private:
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(), force_ = Eigen::Vector3d::Zero(),
                  energy_ = Eigen::Vector3d::Zero();
};

/// The passivity controller of the same paper, in series with the feedback. `force` is what is
/// about to push a hand that moves with `velocity` (m/s) for `dt` seconds (> 0). Answers with that
/// force and as much damping as takes what `energy` would lack after that, along each axis by
/// itself. It brakes a hand by no more than `most`, N.s/m, since more than the moving mass by dt
/// would throw it back; below that it leaves some of the lack to the next cycle.
Eigen::Vector3d damped(const Eigen::Vector3d& force, const Eigen::Vector3d& velocity,
                       const Eigen::Vector3d& energy, double most, double dt);

}  // namespace robots
