#pragma once
// This is the port at which a feedback pushes a hand that holds a master.

#include <Eigen/Core>

#include "force_feedback/passivity.h"

namespace robots {

/// Says how a tip moves, in the frame and to the scale of the master.
struct TipMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// One thread; only the constructor throws, nothing allocates. A PassivePort observes what a
/// feedback gives the hand, and brakes the hand for what the feedback gives without having got it.
class PassivePort {
 public:
  struct Model {
    double most_force = 20;  ///< N: the feedback pushes no harder along an axis
    bool passive = true;     ///< with the controller; without, the energy is only observed
    double mass = 0.9;       ///< kg: of the least that moves with the hand
  };

  /// Throws std::invalid_argument unless the numbers of the model are finite and not negative.
  explicit PassivePort(const Model& model);

  /// Begins the account with the hand at `position`, where nothing pushes it.
  void beginAt(const Eigen::Vector3d& position) { observer_.beginAt(position); }

  /// Call this in each cycle. `wanted` is the force in N that the feedback would push the hand with
  /// for the next `dt` seconds (> 0), `stored` what it may give back of what the hand has given it,
  /// in J along each axis. Returns the force in N that it may push with.
  Eigen::Vector3d push(const TipMotion& hand, const Eigen::Vector3d& wanted,
                       const Eigen::Vector3d& stored, double dt);

  /// Returns the energy in J that the hand has given along each axis (PassivityObserver). With the
  /// controller the account keeps no more than what is stored.
  const Eigen::Vector3d& energy() const { return observer_.energy(); }

 private:
  Model model_;
  PassivityObserver observer_;
};

}  // namespace robots
