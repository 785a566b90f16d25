#pragma once
// This is the contract of a registration, which says where arms and cameras stand.

#include <suture/annotate.h>

#include <Eigen/Geometry>

namespace robots {

/// Says where things are: slaves and camera in the frame of the scene, whose z points away from the
/// tissue; masters and display in that of the console. The place of an arm is that of the reference
/// frame in which it gives its poses, which is its base unless set_base_frame() has moved it.
struct SUTURE_TYPE() SceneFrames {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d left_base = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d right_base = Eigen::Isometry3d::Identity();
  /// The left camera is here, with x to the right and y downward in the image, z ahead.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  /// The tissue's surface has this z.
  SUTURE_FIELD(unit("m")) double tissue = -0.16;
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d left_master = Eigen::Isometry3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d right_master = Eigen::Isometry3d::Identity();
  /// The surgeon looks at a picture here, with the axes of the camera: x to the right and y
  /// downward in it, z ahead.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d display = Eigen::Isometry3d::Identity();
};

/// Commands run in the registration's own thread.
class SUTURE_INTERFACE() Registration {
 public:
  virtual ~Registration() = default;

  /// Returns the frames as they were registered last; each rotation is one to 1e-6. Ask with
  /// `frames.at(stamp)` for those to which an image or a pose of that stamp belongs.
  SUTURE_COMMAND() virtual const SceneFrames& frames() const = 0;

  /// Says that the left camera has been moved there. It is ignored, with a warning, unless its
  /// rotation is one.
  SUTURE_COMMAND()
  virtual void set_camera(SUTURE_FIELD(unit("m")) const Eigen::Isometry3d& camera) = 0;
};

}  // namespace robots
