#pragma once
// This is what trackers and cameras see. An image's bytes are bounded by the largest that a
// contract here carries; a camera that needs more provides a contract of its own.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace robots {

/// A PoseArray has the poses of several tools at once. Corresponds to cisst's
/// prmPositionCartesianArrayGet.
struct SUTURE_TYPE() PoseArray {
  SUTURE_FIELD(capacity(15)) std::string reference_frame;
  SUTURE_FIELD(capacity(16, 15)) std::vector<std::string> moving_frames;
  SUTURE_FIELD(capacity(16), unit("m")) std::vector<Eigen::Isometry3d> positions;
  SUTURE_FIELD(capacity(16)) std::vector<bool> visible;
  suture::Time stamp;
  bool valid = false;
};

/// Corresponds to cisst's prmImageFrame.
struct SUTURE_TYPE() ImageFrame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;
  /// Goes row by row, channels interleaved, 8 bits each.
  SUTURE_FIELD(capacity(2097152)) std::vector<std::uint8_t> data;
  suture::Time stamp;
  bool valid = false;
};

/// A CameraInfo is a pinhole camera with its distortion. Corresponds to cisst's prmCameraInfo.
struct SUTURE_TYPE() CameraInfo {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// The order is k1, k2, p1, p2, k3 (Brown and Conrady).
  std::array<double, 5> distortion{};
  SUTURE_FIELD(unit("px")) Eigen::Matrix3d intrinsic = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d rectification = Eigen::Matrix3d::Identity();
  /// The matrix is 3 x 4, of the rectified image.
  Eigen::Matrix<double, 3, 4> projection = Eigen::Matrix<double, 3, 4>::Zero();
  suture::Time stamp;
  bool valid = false;
};

/// A DepthMap is a cloud of coloured points. Corresponds to cisst's prmDepthMap.
struct SUTURE_TYPE() DepthMap {
  SUTURE_FIELD(capacity(15)) std::string reference_frame;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// Each point has three entries: x, y, z.
  SUTURE_FIELD(capacity(196608), unit("m")) std::vector<float> points;
  /// Each point has three entries: red, green, blue.
  SUTURE_FIELD(capacity(196608)) std::vector<std::uint8_t> color;
  suture::Time stamp;
  bool valid = false;
};

}  // namespace robots
