#pragma once
// Decides from a recording whether an arm held while a part of its system was cut off, or the
// emergency stop was pressed.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "recorder/recording.h"

namespace robots {

struct HoldJudgement {
  /// s from its last motion before the break until that; none if it never moved before.
  std::optional<double> rested_before;
  double held_after = 0;  ///< s from the break until the set-point moved for the last time
  /// s from the mending until it moved again; none if it did not.
  std::optional<double> resumed_after;
  /// m, since the break: by how much the set-point moved farther from one row to the next than a
  /// fast hand does.
  double largest_jump = 0;
};

/// Rows come by ascending stamp; `broken` and `mended` are on their clock.
HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended);

/// Each bound that is missed, in words. Bounds: it moves until the break, holds within half a
/// second, moves again, and jumps by no more than 3 mm, which is what an arm's data may lag behind
/// at the demo's speeds.
std::vector<std::string> violations(const HoldJudgement& judgement);

}  // namespace robots
