#pragma once
// This is the geometry of a stereo endoscope.

#include <Eigen/Geometry>
#include <cstdint>

namespace robots {

enum class Eye : std::uint8_t { Left, Right };

/// A CameraPair is a plain value: two equal pinholes side by side, whose images are rectified.
/// Points are in the frame of the left one, in m: x to the right and y downward in the image, z
/// ahead. Pixels count from the centre of the upper left one. The numbers are those of the Surgical
/// Robotics Challenge's world_stereo (collaborative-robotics/surgical_robotics_challenge).
struct CameraPair {
  int width = 640, height = 480;  ///< px
  double focal = 351;             ///< px
  double baseline = 0.004;        ///< m, from the left to the right pinhole
  /// The right camera is turned by this toward the left one's axis, in rad. Code that
  /// triangulates does not know it: it is what a calibration has missed, or heat has changed since.
  double vergence = 0;

  /// What is nearer to the camera than this, in m, is out of focus and counts as unseen.
  static constexpr double kNearest = 0.005;
  bool sees(const Eigen::Vector3d& point) const { return point.z() >= kNearest; }

  Eigen::Vector2d centre() const { return {(width - 1) / 2.0, (height - 1) / 2.0}; }

  /// Returns where a point that the cameras see is in the image, in px; it may be outside.
  Eigen::Vector2d project(Eye eye, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d seen = inFrameOf(eye) * point;
    return centre() + focal / seen.z() * seen.head<2>();
  }

  /// Returns the transform from the frame of the left camera to that of an eye.
  Eigen::Isometry3d inFrameOf(Eye eye) const {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    if (eye == Eye::Left) return frame;
    frame.rotate(Eigen::AngleAxisd(vergence, Eigen::Vector3d::UnitY()));
    return frame.translate(Eigen::Vector3d(-baseline, 0, 0));
  }

  /// Returns the error of the depth in m, at a depth of `z` m, for an error of `disparity` px.
  double depthOf(double z, double disparity) const {
    return z * z / (focal * baseline) * disparity;
  }
  /// Returns the standard deviation in m of each coordinate of a point, for that of its disparity
  /// in px: the deviation of the depth is along the ray, and across it there is that of the place
  /// in the image.
  Eigen::Vector3d deviation(const Eigen::Vector3d& point, double disparity) const {
    const double depth = depthOf(point.z(), disparity);
    const Eigen::Vector3d along = depth / point.z() * point.cwiseAbs();
    const double across = point.z() / focal * disparity;
    return along + Eigen::Vector3d(across, across, 0);
  }
};

}  // namespace robots
