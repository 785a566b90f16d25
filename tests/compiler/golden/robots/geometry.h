#pragma once
// Belongs to another target in these tests: its types are used, nothing is generated for it.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>

namespace robots {

/// A pose with its time.
struct SUTURE_TYPE() PoseStamped {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::chrono::steady_clock::time_point stamp;
  bool valid = false;
};

}  // namespace robots
