#pragma once
// Draws what an endoscope would see of a strand between two instruments.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "robot_types/vision.h"
#include "strand/strand.h"
#include "vision/camera_pair.h"

namespace robots {

/// Balls with a smooth edge, lit from the camera, in front of plain tissue, with the noise of a
/// sensor. Belongs to one thread.
class Painter {
 public:
  /// `noise`: standard deviation of a channel, of 255. The same seed gives the same noise.
  Painter(const CameraPair& cameras, double noise, std::uint64_t seed = 1);

  /// Fills all of `image` but its stamp. The strand, which ends at the two tips, is in the frame of
  /// the left camera, m, and the cameras see() all of it. Allocates for the first image.
  void paint(Eye eye, const Strand::Nodes& strand, ImageFrame& image);

 private:
  void addNoise(ImageFrame& image);

  CameraPair cameras_;
  std::vector<std::int8_t> noise_;
  std::uint64_t next_;
};

}  // namespace robots
