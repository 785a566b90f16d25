#pragma once
// This decides from a recording if an arm held while a part of its system was cut off, or the
// emergency stop was pressed.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "recorder/jumps.h"
#include "recorder/recording.h"

namespace robots {

struct HoldJudgement {
  /// Its last motion before the break was this many s before the break; none if it never moved
  /// before.
  std::optional<double> rested_before;
  double held_after = 0;  ///< s from the break until the set-point moved for the last time
  /// It moved again, while it was enabled, this many s after the mending; none if it did not.
  std::optional<double> resumed_after;
  bool enabled_at_end = true;  ///< it would have obeyed
  Jumps jumps;                 ///< since the break
};

/// Rows must come by ascending stamp; `broken` and `mended` are on their clock.
HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended);

struct HoldBounds {
  double held_after = 0.5;  ///< s, at most; a stop has to act sooner than the loss of a peer
};

/// Returns each bound that is missed, in words. The bounds are that it moves until half a second
/// before the break at least, holds soon, moves again, and does not jump. To turn is to move.
std::vector<std::string> violations(const HoldJudgement& judgement, const HoldBounds& bounds = {});

}  // namespace robots
