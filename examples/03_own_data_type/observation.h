#pragma once
// This is the data type of this example: a plain struct. Nobody writes code for how it goes over a
// wire.

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace tracking {

enum class SUTURE_TYPE() Visibility : std::uint8_t { Hidden, Partial, Full };

struct SUTURE_TYPE() Marker {
  std::uint32_t number = 0;
  SUTURE_FIELD(unit("m")) Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// An Observation is what a tracking camera knows of a surgical instrument at one moment, in the
/// camera's frame.
struct SUTURE_TYPE() Observation {
  SUTURE_FIELD(capacity(31)) std::string instrument;
  Visibility visibility = Visibility::Hidden;
  /// The tip of the instrument has this pose.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
  /// The camera sees these markers.
  SUTURE_FIELD(capacity(8)) std::vector<Marker> markers;
  /// The jaws of the instrument are open this far.
  SUTURE_FIELD(unit("rad"), range(0, 1.6)) double jaw_angle = 0;
};

}  // namespace tracking
