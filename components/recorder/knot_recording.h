#pragma once
// This records how a knot was placed: the truth, what the cameras saw, and if it was guided.

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <vector>

#include "strand/strand.h"
#include "strand/strand_view.h"
#include "vision/knot_vision.h"

namespace robots {

/// A KnotRow is one moment. The truth is in the scene's frame, the sighting in the camera's.
struct KnotRow {
  StrandState strand;
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();  ///< in the scene
  double tissue = 0;      ///< m: z of the tissue's surface in the scene, as it is registered
  KnotSighting sighting;  ///< the last one at that moment
  bool guiding = false;

  /// Returns the true place of the knot, in the scene, in m.
  Eigen::Vector3d knot() const { return strand.nodes.col(Strand::kKnot); }
};

/// Writes one row, whose strand is valid, as one line of JSON. Stamps are ns of the steady clock.
void write(std::ostream& out, const KnotRow& row);

struct KnotRecording {
  std::vector<KnotRow> rows;  ///< their stamps ascend
  std::uint64_t lost = 0;     ///< rows that the file did not take
};

/// Returns a whole recording, which must not be written any more. Throws suture::SetupError that
/// names the file and the line.
KnotRecording readKnotRecording(const std::filesystem::path& file);

}  // namespace robots
