#pragma once
// This is the path of a scripted surgeon's hand.

#include <Eigen/Geometry>

namespace robots {

struct HandPathShape {
  double amplitude;  ///< m, of the widest axis
  double turn;       ///< rad, of the widest axis
  double frequency;  ///< Hz, of the fastest axis
  double ramp;       ///< s, until the full amplitude is reached
};

/// Goes around `centre`: three sines of incommensurable frequencies along, and three about, the
/// axes of the frame in which `centre` is given, faded in by a minimum-jerk blend. Another blend
/// leads from `start` to the centre meanwhile, in twice that time. So position, velocity and
/// acceleration are continuous, and the last two are zero at t = 0; speed never exceeds maxSpeed().
class HandPath {
 public:
  /// The centre is where the path starts.
  HandPath(const Eigen::Isometry3d& start, const HandPathShape& shape)
      : HandPath(start, start, shape) {}
  HandPath(const Eigen::Isometry3d& start, const Eigen::Isometry3d& centre,
           const HandPathShape& shape)
      : start_(start), centre_(centre), shape_(shape) {}

  /// Returns the hand `t` seconds (>= 0) after it started.
  Eigen::Isometry3d at(double t) const;

  /// Returns the bound of the speed in m/s.
  double maxSpeed() const;

 private:
  Eigen::Isometry3d centreAt(double t) const;

  Eigen::Isometry3d start_, centre_;
  HandPathShape shape_;
};

}  // namespace robots
