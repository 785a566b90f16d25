#pragma once
// Keeps how a knot was placed: the truth, what the cameras saw, and whether it was
// guided.

#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <iosfwd>
#include <vector>

#include "strand/strand_view.h"
#include "vision/knot_vision.h"

namespace robots {

/// One moment; truth in the scene's frame, the sighting in the camera's.
struct KnotRow {
  StrandState strand;
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();  ///< in the scene
  KnotSighting sighting;                                     ///< the last one at that moment
  bool guiding = false;
};

/// Writes one row as one line of JSON. Stamps are ns of the steady clock.
void write(std::ostream& out, const KnotRow& row);

/// All of a recording that nobody writes any more. Throws suture::SetupError that names the file
/// and the line.
std::vector<KnotRow> readKnotRecording(const std::filesystem::path& file);

}  // namespace robots
