#pragma once
// This is the contract of the vision system, which says where the knot and both tips are.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Core>

namespace robots {

/// Its points are in the frame of the left camera: x to the right and y downward in the image, z
/// ahead.
struct SUTURE_TYPE() KnotSighting {
  SUTURE_FIELD(unit("m")) Eigen::Vector3d knot = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m")) Eigen::Vector3d left_tip = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m")) Eigen::Vector3d right_tip = Eigen::Vector3d::Zero();
  /// The images were exposed at this time.
  suture::Time stamp;
  /// This is false unless both eyes see all three.
  bool valid = false;
};

class SUTURE_INTERFACE() KnotVision {
 public:
  virtual ~KnotVision() = default;

  /// Returns what the last pair of images showed.
  SUTURE_COMMAND() virtual const KnotSighting& sighting() const = 0;
};

}  // namespace robots
