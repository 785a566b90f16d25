#pragma once
// The judge is told this of a trial: what is true at an instant, and what follows from it.

#include <Eigen/Geometry>
#include <optional>

#include "experiment/result.h"
#include "teleop/follow_law.h"

namespace experiment {

/// A Pair is a slave and the master that leads it, each in its own base frame.
struct Pair {
  Eigen::Isometry3d master, slave, setpoint;
};

/// A Truth is what is true at one instant.
struct Truth {
  Eigen::Vector3d knot;  ///< in the scene, m
  bool guided = false;
  Pair left, right;
};

/// Tells how far each slave is from where its master asks it to be now, from where both were when
/// the guide last began. It is a value.
class Tracking {
 public:
  /// `truth` must be of instants that ascend.
  Moment momentOf(const Truth& truth);

 private:
  std::optional<robots::FollowLaw> left_, right_;
};

}  // namespace experiment
