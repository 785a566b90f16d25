#pragma once
// This draws what an endoscope would see of a strand between two instruments.

#include <Eigen/Geometry>
#include <memory>

#include "robot_types/vision.h"
#include "strand/strand.h"
#include "vision/camera_pair.h"

namespace robots {

/// A View is what is before the cameras, in the frame of the left one, in m.
struct View {
  Strand::Nodes strand;  ///< from one tip to the other
  /// The plane is the tissue's surface; its normal points away from the tissue.
  Eigen::Hyperplane<double, 3> tissue{Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 0.16)};
};

/// Returns what a camera that stands at `camera` in a scene has before it. The scene's z points
/// away from the tissue, whose surface is at `tissue`, in m.
View seenFrom(const Eigen::Isometry3d& camera, const Strand::Nodes& strand, double tissue);

/// One thread, which is that of the first paint(); it starts no other (one_thread.h). Draws with
/// OpenGL, in memory: the strand as a tube, knot and tips as balls in the colours of their markers,
/// instruments that come from the sides, and tissue below, lit from between both eyes. The image is
/// exact and sharp; image_sensor.h makes of it what a camera would.
class Painter {
 public:
  explicit Painter(const CameraPair& cameras);
  ~Painter();

  /// Fills all of `image` but its stamp. The cameras must see() all of the strand. Allocates, and
  /// takes some tenths of a second for the first image.
  void paint(Eye eye, const View& view, ImageFrame& image);

 private:
  class Studio;

  CameraPair cameras_;
  std::unique_ptr<Studio> studio_;  // made by the thread that draws
};

}  // namespace robots
