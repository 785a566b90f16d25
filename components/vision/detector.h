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

/// The centre of what has a marker's colour, weighted by how much: good to hundredths of a pixel
/// where nothing hides a part of it. Reads nothing but the pixels. An image whose data are not as
/// large as it says has no markers. Does not allocate; any thread.
Detections detect(const ImageFrame& image);

/// The markers that both eyes see, before the cameras and at one height, as rectified images have
/// it. Any thread.
MarkerPoints locate(const CameraPair& cameras, const Detections& left, const Detections& right);

}  // namespace robots
