#pragma once
// The same for the pages about CRTK, whose payloads are Eigen's.
#include <suture/annotate.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace demo {
struct SUTURE_TYPE() Pose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};
struct SUTURE_TYPE() Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};
}  // namespace demo
