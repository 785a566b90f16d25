#pragma once
// This decides from a recording if an arm held while a part of its system was cut off, or the
// emergency stop was pressed.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "recorder/recording.h"

namespace robots {

struct HoldJudgement {
  /// In s: its last motion before the break was this long before the break; none if it never
  /// moved before.
  std::optional<double> rested_before;
  double held_after = 0;  ///< s from the break until the set-point moved for the last time
  /// In s: it moved again, while it was enabled, this long after the mending; none if it did
  /// not.
  std::optional<double> resumed_after;
  bool enabled_at_end = true;  ///< it would have obeyed
  /// Since the break, the set-point moved farther by this within 50 ms, or less, than a fast hand
  /// does, in m, and turned farther by this, in rad.
  double largest_jump = 0;
  double largest_turn = 0;
};

/// Rows must come by ascending stamp; `broken` and `mended` are on their clock.
HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended);

struct HoldBounds {
  double held_after = 0.5;  ///< s, at most; a stop has to act sooner than the loss of a peer
};

/// Returns each bound that is missed, in words. The bounds are that it moves until half a second
/// before the break at least, holds soon, moves again, and jumps by no more than 3 mm and 3
/// degrees, which is how far an arm's data may lag behind at the demo's speeds. To turn is to move.
std::vector<std::string> violations(const HoldJudgement& judgement, const HoldBounds& bounds = {});

}  // namespace robots
