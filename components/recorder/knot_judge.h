#pragma once
// This decides from a recording if a knot came to its target.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recorder/knot_recording.h"

namespace robots {

/// These bounds are in the frame of the scene, and a guide with fixtures keeps the knot and the
/// tips within them.
struct KnotBounds {
  Eigen::Vector3d approach{0, 0, -1};  ///< the direction in which the knot comes to its target
  double radius = 0;                   ///< m: how wide the corridor is about that at the target
  double slope = 0;       ///< how much the corridor widens for each metre before the target
  double separation = 0;  ///< m: how near the tips may come to each other
};

struct KnotJudgement {
  double start = 0;           ///< m from the target when guiding began
  double error = 0;           ///< m from the target, mean of the last half second
  double guided_at_end = 0;   ///< share of the rows of the last half second
  double sighted = 0;         ///< share of the guided rows with a valid sighting
  double sighting_error = 0;  ///< m, p99: a sighting against the truth at its stamp
  std::size_t rows = 0;       ///< guided ones
  /// These are in m, of all guided rows: how far the knot was outside of the corridor or beyond the
  /// target, less how far it was when guiding began; how deep a tip was in the tissue; and by how
  /// much the tips were nearer to each other than they may be. Below zero there was room.
  std::optional<double> outside, depth, contact;
};

/// Rows must come by ascending stamp; `target` is in the scene, in m. Judges by the true strand,
/// not by what the cameras saw. Without `bounds` nothing keeps the knot in a corridor.
KnotJudgement judgeKnot(const std::vector<KnotRow>& rows, const Eigen::Vector3d& target,
                        const std::optional<KnotBounds>& bounds = {});

/// Returns each bound that is missed, in words; nothing if the knot was placed. The bounds are that
/// it is within 1 mm of the target, after at least 10 mm of the way, that it was guided for half of
/// the last half second, that the cameras saw it for nine tenths of the guided rows, within 1 mm,
/// and that neither knot nor tips were ever more than 2 mm where the fixtures do not let them:
/// cameras may be off by 1 mm, and the knot swings on its strand. No lateness moves it there,
/// because a knot that is late is where the corridor is wider.
std::vector<std::string> violations(const KnotJudgement& judgement);

}  // namespace robots
