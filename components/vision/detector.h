#pragma once
// This finds the knot and the tips in images, and from two images where they are.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "robot_types/vision.h"
#include "vision/camera_pair.h"
#include "vision/markers.h"

namespace robots {

/// A Detection is a marker in one image.
struct Detection {
  Eigen::Vector2d place;  ///< px: its centre
  double area;            ///< px2: how much of the image it covers
};
/// Holds each marker by its number; none for one that cannot be seen.
using Detections = std::array<std::optional<Detection>, kMarkers>;
/// Holds the place of each marker in m, in the frame of the left camera.
using MarkerPoints = std::array<std::optional<Eigen::Vector3d>, kMarkers>;

/// In px: a disparity that detect() finds has this standard deviation, with the noise of the
/// synthetic endoscope; tests/unit/vision/accuracy_test.cpp checks it.
constexpr double kDisparityNoise = 0.05;

/// Any thread; OpenCV allocates. Returns for each marker the centre of the largest spot of its
/// colour, good to hundredths of a pixel if nothing hides a part of it. One that reaches the
/// image's edge is not seen, because a part of it is missing. Reads only the pixels. An image whose
/// data are not as large as it says has no markers.
Detections detect(const ImageFrame& image);

/// Returns the point that both eyes see, from its places in the images, in px. An error of the
/// disparity of d px moves it by CameraPair::depthOf(z, d). The disparity must be above zero.
Eigen::Vector3d triangulate(const CameraPair& cameras, const Eigen::Vector2d& left,
                            const Eigen::Vector2d& right);

/// Any thread. Returns the markers that both eyes see as a whole, in front of the cameras and at
/// the same height in both images, as it is in rectified ones. One of which an image shows less
/// than the other, by 4 %, or both less than 70 % of its ball, is partly hidden, so its centre is
/// elsewhere.
MarkerPoints locate(const CameraPair& cameras, const Detections& left, const Detections& right);

}  // namespace robots
