#pragma once
// Keeps how a knot was placed: the truth, what the cameras saw, and whether it was guided.

#include <Eigen/Geometry>
#include <filesystem>
#include <iosfwd>
#include <vector>

#include "strand/strand.h"
#include "strand/strand_view.h"
#include "vision/knot_vision.h"

namespace robots {

/// One moment; truth in the scene's frame, the sighting in the camera's.
struct KnotRow {
  StrandState strand;
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();  ///< in the scene
  KnotSighting sighting;                                     ///< the last one at that moment
  bool guiding = false;

  /// The true place of the knot, in the scene, m.
  Eigen::Vector3d knot() const { return strand.nodes.col(Strand::kKnot); }
};

/// Writes one row, whose strand is valid, as one line of JSON. Stamps are ns of the steady clock.
void write(std::ostream& out, const KnotRow& row);

/// All of a recording that nobody writes any more. Throws suture::SetupError that names the file
/// and the line.
std::vector<KnotRow> readKnotRecording(const std::filesystem::path& file);

}  // namespace robots
