#pragma once
// Bodies that OpenGL draws.

#include <Eigen/Geometry>

#include "vision/markers.h"

namespace robots {

/// Shapes of one colour, lit by what light there is, and to be seen from outside alone, the ground
/// from the side of its normal. All points are in the frame that the model
/// view matrix is for, m. Belongs to the context of OpenGL in which it was made, and draws while
/// that is current.
class Solids {
 public:
  Solids();

  void ball(const Eigen::Vector3d& centre, double radius, Colour colour) const;
  /// Without its ends.
  void tube(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
            Colour colour) const;
  /// A square of a plane about the point that is nearest to `centre`, not of one brightness all
  /// over. Its sides are twice `reach`, m.
  void ground(const Eigen::Hyperplane<double, 3>& plane, const Eigen::Vector3d& centre,
              double reach, Colour colour) const;

 private:
  unsigned ball_, tube_;  // lists of the context: of radius 1, and of length 1 along z
};

}  // namespace robots
