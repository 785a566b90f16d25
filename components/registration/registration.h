#pragma once
// The contract of a registration: where arms and cameras stand.

#include <suture/annotate.h>

#include <Eigen/Geometry>

namespace robots {

/// Frames in the frame of the scene, m.
struct SUTURE_TYPE() SceneFrames {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d left_base = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d right_base = Eigen::Isometry3d::Identity();
  /// The left camera: x to the right and y downward in the image, z ahead.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
};

class SUTURE_INTERFACE() Registration {
 public:
  virtual ~Registration() = default;

  SUTURE_COMMAND() virtual const SceneFrames& frames() const = 0;
};

}  // namespace robots
