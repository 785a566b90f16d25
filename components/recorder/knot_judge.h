#pragma once
// This decides from a recording if a knot came to its target.

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "recorder/knot_recording.h"

namespace robots {

struct KnotJudgement {
  double start = 0;           ///< m from the target when guiding began
  double error = 0;           ///< m from the target, mean of the last half second
  double guided_at_end = 0;   ///< share of the rows of the last half second
  double sighted = 0;         ///< share of the guided rows with a valid sighting
  double sighting_error = 0;  ///< m, p99: a sighting against the truth at its stamp
  std::size_t rows = 0;       ///< guided ones
};

/// Rows must come by ascending stamp; `target` is in the scene, in m. Judges by the true strand,
/// not by what the cameras saw.
KnotJudgement judgeKnot(const std::vector<KnotRow>& rows, const Eigen::Vector3d& target);

/// Returns each bound that is missed, in words; nothing if the knot was placed. The bounds are that
/// it is within 1 mm of the target, after at least 10 mm of the way, that it was guided for half of
/// the last half second, and that the cameras saw it for nine tenths of the guided rows, within 1
/// mm.
std::vector<std::string> violations(const KnotJudgement& judgement);

}  // namespace robots
