#pragma once
// Draws what an endoscope would see of a strand between two instruments.

#include <Eigen/Geometry>
#include <memory>

#include "robot_types/vision.h"
#include "strand/strand.h"
#include "vision/camera_pair.h"

namespace robots {

/// What is before the cameras: in the frame of the left one, m.
struct View {
  Strand::Nodes strand;  ///< from one tip to the other
  /// The tissue's surface; its normal points away from the tissue.
  Eigen::Hyperplane<double, 3> tissue{Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 0.16)};
};

/// What a camera that stands at `camera` in a scene has before it. The scene's z points away from
/// the tissue, whose surface is at `tissue`, m.
View seenFrom(const Eigen::Isometry3d& camera, const Strand::Nodes& strand, double tissue);

/// Draws with OpenGL, in memory: the strand as a tube, knot and tips as balls in the colours of
/// their markers, instruments that come from the sides, and tissue below, lit from between both
/// eyes. Exact and sharp; what a camera makes of it is image_sensor.h. It draws in one thread, that
/// of the first paint(), and starts none (one_thread.h).
class Painter {
 public:
  explicit Painter(const CameraPair& cameras);
  ~Painter();

  /// Fills all of `image` but its stamp. The cameras see() all of the strand. Allocates, and takes
  /// some tenths of a second for the first image.
  void paint(Eye eye, const View& view, ImageFrame& image);

 private:
  class Studio;

  CameraPair cameras_;
  std::unique_ptr<Studio> studio_;  // made by the thread that draws
};

}  // namespace robots
