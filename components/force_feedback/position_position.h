#pragma once
// How a hand feels through its master what the slave does.

#include <Eigen/Core>

#include "force_feedback/passivity.h"

namespace robots {

/// How a tip moves, in the frame and to the scale of the master.
struct TipMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

struct CouplingGains {
  double stiffness = 300;  ///< N/m
  double damping = 3;      ///< N.s/m
};

/// N: what draws one arm to where the other one is known to be. With equal gains of both arms, each
/// knowing the other with a delay, this is the coupling named position-position.
inline Eigen::Vector3d coupling(const CouplingGains& gains, const TipMotion& own,
                                const TipMotion& other) {
  return gains.stiffness * (other.position - own.position) +
         gains.damping * (other.velocity - own.velocity);
}

/// All numbers are our own choice.
struct PositionPositionModel {
  CouplingGains gains = {};
  double most_force = 20;  ///< N: the coupling pushes no harder along an axis
  bool passive = true;     ///< with the passivity controller; without, it is only observed
  double mass = 0.9;       ///< kg: of the least that moves with the hand
};

/// The master's half of the coupling, with the passivity observer and controller at the hand. A
/// delay makes the coupling active, for the slave that pulls at the hand is where it was. Confined
/// to one thread; nothing but the constructor throws, nothing allocates.
class PositionPosition {
 public:
  /// Throws std::invalid_argument unless all its numbers are finite and not negative.
  explicit PositionPosition(const PositionPositionModel& model);

  /// The coupling begins with the master at `position`.
  void beginAt(const Eigen::Vector3d& position) { observer_.beginAt(position); }
  /// Each cycle: the force on the hand for the next `dt` seconds (> 0), N.
  Eigen::Vector3d force(const TipMotion& master, const TipMotion& slave, double dt);

  /// What the hand has given along each axis, J (PassivityObserver).
  const Eigen::Vector3d& energy() const { return observer_.energy(); }

 private:
  PositionPositionModel model_;
  PassivityObserver observer_;
};

}  // namespace robots
