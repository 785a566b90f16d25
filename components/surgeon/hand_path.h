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

/// Around `centre`: three sines of incommensurable frequencies along, and three about, the axes of
/// the frame that `centre` is expressed in, faded in by a minimum-jerk blend. Another one leads
/// from `start` to the centre meanwhile, in twice that time. So position, velocity and acceleration
/// are continuous and the last two are zero at t = 0; speed never exceeds maxSpeed().
class HandPath {
 public:
  /// Its centre is where it starts.
  HandPath(const Eigen::Isometry3d& start, const HandPathShape& shape)
      : HandPath(start, start, shape) {}
  HandPath(const Eigen::Isometry3d& start, const Eigen::Isometry3d& centre,
           const HandPathShape& shape)
      : start_(start), centre_(centre), shape_(shape) {}

  /// The hand `t` seconds (>= 0) after it set out.
  Eigen::Isometry3d at(double t) const;

  /// m/s
  double maxSpeed() const;

 private:
  Eigen::Isometry3d centreAt(double t) const;

  Eigen::Isometry3d start_, centre_;
  HandPathShape shape_;
};

}  // namespace robots
