#pragma once
// Finds the knot and the tips in images, and from two images where they are.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "robot_types/vision.h"
#include "vision/camera_pair.h"
#include "vision/markers.h"

namespace robots {

/// px, of each marker, by its number; none for one that cannot be seen.
using Detections = std::array<std::optional<Eigen::Vector2d>, kMarkers>;
/// m, in the frame of the left camera.
using MarkerPoints = std::array<std::optional<Eigen::Vector3d>, kMarkers>;

/// px: the standard deviation of a disparity that detect() finds, with the noise of the synthetic
/// endoscope; tests/unit/vision/accuracy_test.cpp holds it to this.
constexpr double kDisparityNoise = 0.05;

/// The centre of the largest spot of a marker's colour: good to hundredths of a pixel where nothing
/// hides a part of it. One that reaches the image's edge is not seen, for it is not all there.
/// Reads nothing but the pixels. An image whose data are not as large as it says has no markers.
/// OpenCV allocates; any thread.
Detections detect(const ImageFrame& image);

/// The point that both eyes see, from its places in the images, px. An error of the disparity of
/// d px moves it by CameraPair::depthOf(z, d). The disparity must be above zero.
Eigen::Vector3d triangulate(const CameraPair& cameras, const Eigen::Vector2d& left,
                            const Eigen::Vector2d& right);

/// The markers that both eyes see, before the cameras and at one height, as rectified images have
/// it. Any thread.
MarkerPoints locate(const CameraPair& cameras, const Detections& left, const Detections& right);

}  // namespace robots
