#pragma once
// These are bodies that OpenGL draws.

#include <Eigen/Geometry>

#include "vision/markers.h"

namespace robots {

/// Belongs to the context of OpenGL in which it was made, and draws while that is current. Draws
/// shapes of one colour, lit by the present light. They can be seen only from outside, and the
/// ground only from the side of its normal. All points are in the frame of the model view matrix,
/// in m.
class Solids {
 public:
  Solids();

  void ball(const Eigen::Vector3d& centre, double radius, Colour colour) const;
  /// Draws a tube without its ends.
  void tube(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
            Colour colour) const;
  /// Draws a square of the plane about that of its points which is nearest to `centre`. Its sides
  /// are twice `reach`, in m, and its brightness varies from place to place.
  void ground(const Eigen::Hyperplane<double, 3>& plane, const Eigen::Vector3d& centre,
              double reach, Colour colour) const;

 private:
  unsigned ball_, tube_;  // lists of the context: of radius 1, and of length 1 along z
};

}  // namespace robots
