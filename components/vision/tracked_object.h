#pragma once
// This is the contract of something that cameras follow: CRTK (collaborative-robotics.github.io).

#include <suture/annotate.h>

#include "robot_types/cartesian.h"
#include "robot_types/pose.h"

namespace robots {

/// A TrackedObject is a ball in the frame of the left camera: x to the right and y downward in the
/// image, z ahead. It has no orientation, so that of its pose is the camera's.
class SUTURE_INTERFACE(crtk()) TrackedObject {
 public:
  virtual ~TrackedObject() = default;

  /// Says where it is at the stamp, which is that of the tracker's cycle: images are old when they
  /// come, and this is what they showed, extrapolated by its velocity. It is not valid unless the
  /// last pair of images showed it, and not long ago.
  SUTURE_COMMAND() virtual const PoseStamped& measured_cp() const = 0;
  /// Says how fast it moves; it is valid when the pose is.
  SUTURE_COMMAND() virtual const Twist& measured_cv() const = 0;
};

}  // namespace robots
