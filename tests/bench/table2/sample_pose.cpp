#include "bench/table2/sample_pose.h"

namespace bench {

robots::PosePrm samplePose() {
  robots::PosePrm pose;
  pose.timestamp = suture::now();
  pose.valid = true;
  pose.moving_frame = "tool";
  pose.reference_frame = "base";
  pose.position.translate(Eigen::Vector3d(0.1, -0.02, 0.3));
  pose.position.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  return pose;
}

}  // namespace bench
