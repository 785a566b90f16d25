#pragma once
// The path of a scripted surgeon's hand.

#include <Eigen/Geometry>

namespace robots {

struct HandPathShape {
  double amplitude;  ///< m, of the widest axis
  double turn;       ///< rad, of the widest axis
  double frequency;  ///< Hz, of the fastest axis
  double ramp;       ///< s, until the full amplitude is reached
};

/// Around `start`: three sines of incommensurable frequencies along, and three about, the axes of
/// the frame that `start` is expressed in, faded in by a minimum-jerk blend. So position, velocity
/// and acceleration are continuous and the last two are zero at t = 0; speed never exceeds
/// maxSpeed().
class HandPath {
 public:
  HandPath(const Eigen::Isometry3d& start, const HandPathShape& shape)
      : start_(start), shape_(shape) {}

  /// The hand `t` seconds (>= 0) after it set out.
  Eigen::Isometry3d at(double t) const;

  /// m/s
  double maxSpeed() const;

 private:
  Eigen::Isometry3d start_;
  HandPathShape shape_;
};

}  // namespace robots
