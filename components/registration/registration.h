#pragma once
// The contract of a registration: where arms and cameras stand.

#include <suture/annotate.h>

#include <Eigen/Geometry>

namespace robots {

/// Where things are in the frame of the scene, whose z points away from the tissue.
struct SUTURE_TYPE() SceneFrames {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d left_base = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d right_base = Eigen::Isometry3d::Identity();
  /// The left camera: x to the right and y downward in the image, z ahead.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  /// The tissue's surface: its z.
  SUTURE_FIELD(unit("m")) double tissue = -0.16;
};

class SUTURE_INTERFACE() Registration {
 public:
  virtual ~Registration() = default;

  /// As they were registered last; each rotation is one to 1e-6.
  SUTURE_COMMAND() virtual const SceneFrames& frames() const = 0;
};

}  // namespace robots
