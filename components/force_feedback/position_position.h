#pragma once
// This lets a hand feel through its master what the slave does.

#include <Eigen/Core>

#include "force_feedback/passive_port.h"

namespace robots {

struct CouplingGains {
  double stiffness = 300;  ///< N/m
  double damping = 3;      ///< N.s/m
};

/// Returns the force in N that draws one arm to where the other one is known to be. With equal
/// gains of both arms, where each knows the other with a delay, this is the coupling named
/// position-position.
inline Eigen::Vector3d coupling(const CouplingGains& gains, const TipMotion& own,
                                const TipMotion& other) {
  return gains.stiffness * (other.position - own.position) +
         gains.damping * (other.velocity - own.velocity);
}

/// All of these numbers are our own choice.
struct PositionPositionModel {
  CouplingGains gains = {};
  PassivePort::Model port = {};
};

/// One thread; only the constructor throws, nothing allocates. A PositionPosition is the master's
/// half of the coupling, with the passivity observer and controller at the hand. A delay makes the
/// coupling active, because the slave pulls at the hand from where it was.
class PositionPosition {
 public:
  /// Throws std::invalid_argument unless all numbers of the model are finite and not negative.
  explicit PositionPosition(const PositionPositionModel& model);

  /// Begins the coupling with the master at `position`.
  void beginAt(const Eigen::Vector3d& position) { port_.beginAt(position); }
  /// Call this in each cycle. Returns the force on the hand for the next `dt` seconds (> 0), in N.
  Eigen::Vector3d force(const TipMotion& master, const TipMotion& slave, double dt);

  /// Returns the energy in J that the hand has given along each axis (PassivePort). With the
  /// controller the account keeps no more than the spring of the coupling holds, because friction
  /// at the slave has taken the rest.
  const Eigen::Vector3d& energy() const { return port_.energy(); }

 private:
  CouplingGains gains_;
  PassivePort port_;
};

}  // namespace robots
