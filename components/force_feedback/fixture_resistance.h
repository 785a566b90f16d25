#pragma once
// This lets a hand feel what the virtual fixtures forbid it.

#include <Eigen/Core>

#include "force_feedback/passive_port.h"

namespace robots {

/// Returns the force in N that resists a hand which leads a tip where fixtures let it not go.
/// `forbidden` is the motion that they forbid, in m/s to the scale of the master, `damping` is in
/// N.s/m. The permitted motion of a convex set that contains standing still is nearest to the
/// wished one, so the power of this force at the hand that wishes is never above zero.
inline Eigen::Vector3d resistance(double damping, const Eigen::Vector3d& forbidden) {
  return -damping * forbidden;
}

/// All of these numbers are our own choice.
struct FixtureResistanceModel {
  double damping = 60;  ///< N.s/m
  PassivePort::Model port = {};
};

/// One thread; only the constructor throws, nothing allocates. A FixtureResistance is what a hand
/// feels of the fixtures, whose news come late: the hand may have turned round meanwhile, and
/// would be pushed on without the passivity controller.
class FixtureResistance {
 public:
  /// Throws std::invalid_argument unless all numbers of the model are finite and not negative.
  explicit FixtureResistance(const FixtureResistanceModel& model);

  /// Begins with the hand at `position`.
  void beginAt(const Eigen::Vector3d& position) { port_.beginAt(position); }
  /// Call this in each cycle. Returns the force on the hand for the next `dt` seconds (> 0), in N.
  Eigen::Vector3d force(const TipMotion& hand, const Eigen::Vector3d& forbidden, double dt) {
    return port_.push(hand, resistance(damping_, forbidden), Eigen::Vector3d::Zero(), dt);
  }
  /// Returns the energy in J that the hand has given along each axis (PassivePort).
  const Eigen::Vector3d& energy() const { return port_.energy(); }

 private:
  double damping_;
  PassivePort port_;
};

}  // namespace robots
