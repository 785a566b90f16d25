#pragma once
// This is the hand that holds a master.

#include <Eigen/Core>

#include "hand/tremor.h"

namespace robots {

/// Describes the hand of an operator whose elbow rests. README.md says which numbers are published,
/// and which are our own estimate.
struct HandModel {
  double mass = 0.9;  ///< kg: the part of the arm that moves with the hand, and what the hand holds
  double damping = 20;     ///< N.s/m
  double stiffness = 400;  ///< N/m
  TremorModel tremor = {};
};

/// One thread; only the constructor throws, nothing allocates. Equal models, targets, forces and
/// times give equal motion.
///
/// A Hand is a mass on a spring and a damper, whose other ends are where the muscles want the hand;
/// it is alike along all axes. Three forces act on it: that of the muscles, the one that the master
/// puts on it, and the one that makes it shake as its tremor says while it holds nothing.
///
/// It is integrated by the implicit midpoint rule, which is stable for any step and conserves
/// energy: over a step mass and spring change by exactly the work of the forces. Lengths are in m
/// in one frame.
class Hand {
 public:
  /// The hand rests at the origin. Throws std::invalid_argument unless the mass is positive and
  /// damping, stiffness and tremor are not negative.
  explicit Hand(const HandModel& model);

  /// Makes the hand rest at `position`, which is its target too. Its tremor goes on as it was.
  void restAt(const Eigen::Vector3d& position);

  /// Lets `dt` seconds (>= 0) pass, in which the muscles lead the hand evenly from the last target
  /// to `target`, while the master pushes it with `force`, N.
  void advance(double dt, const Eigen::Vector3d& target, const Eigen::Vector3d& force);

  const Eigen::Vector3d& position() const { return position_; }
  const Eigen::Vector3d& velocity() const { return velocity_; }  ///< m/s
  /// Returns the force in N of the muscles and the tremor on the hand, as the mean of the last
  /// step.
  const Eigen::Vector3d& muscles() const { return muscles_; }

 private:
  Eigen::Vector3d shaking(double t) const;

  HandModel model_;
  Tremor tremor_;
  double time_ = 0;  // s, of the tremor
  Eigen::Vector3d target_ = Eigen::Vector3d::Zero(), position_ = Eigen::Vector3d::Zero(),
                  velocity_ = Eigen::Vector3d::Zero(), muscles_ = Eigen::Vector3d::Zero();
};

}  // namespace robots
