#pragma once
// OpenCV's small types, none of their lines edited.

#include <suture/annotate.h>

#include <opencv2/core/matx.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace foreign {

SUTURE_EXTERNAL_TYPE(cv::Point3d, x, y, z);
SUTURE_EXTERNAL_TYPE(cv::Matx33d, val);

/// A camera and what it sees.
struct SUTURE_TYPE() View {
  cv::Matx33d intrinsics;
  SUTURE_FIELD(capacity(4)) std::vector<cv::Point3d> points;
};

/// Both sides of it.
class SUTURE_INTERFACE() Camera {
 public:
  virtual ~Camera() = default;
  SUTURE_COMMAND() virtual void aim(const cv::Point3d& at) = 0;
  SUTURE_COMMAND() virtual const View& view() const = 0;
};

}  // namespace foreign
