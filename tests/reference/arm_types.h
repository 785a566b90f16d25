#pragma once
// The types of the contract beside this.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace reference {

enum class SUTURE_TYPE() Mode : std::uint8_t { Disabled, Enabled };

/// A pose with its time.
struct SUTURE_TYPE() PoseStamped {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< tip in base
  suture::Time stamp;
  bool valid = false;
};

struct SUTURE_TYPE() JointState {
  SUTURE_FIELD(capacity(8, 15)) std::vector<std::string> name;
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position;
};

}  // namespace reference
