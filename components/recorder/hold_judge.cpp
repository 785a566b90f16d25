#include "recorder/hold_judge.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "recorder/judging.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kDegree = std::numbers::pi / 180;  // rad
constexpr double kStill = 1e-9;                     // m
constexpr double kUnturned = 1e-6;                  // rad
constexpr double kLongestRest = 0.5;                // s, of an arm that moves
constexpr double kJumpTime = 0.05;                  // s: what is slower is no jump
constexpr double kLargestJump = 0.003;              // m
constexpr double kLargestTurn = 3 * kDegree;        // rad
constexpr double kFastest = 0.25;                   // m/s, of a fast hand
constexpr double kFastestTurn = 3;                  // rad/s, of a fast hand

/// Returns for how long in s an arm may have moved from one row to the next. Rows that are far
/// apart permit no more than a few cycles, because somebody stood still between them.
double longestMotion(const ArmRow& before, const ArmRow& after) {
  constexpr double kLongest = 0.025;  // s
  return std::min(secondsBetween(before.stamp, after.stamp), kLongest);
}

double stepBetween(const ArmRow& before, const ArmRow& after) {
  return (after.setpoint.translation() - before.setpoint.translation()).norm();
}

double turnBetween(const ArmRow& before, const ArmRow& after) {
  return Eigen::AngleAxisd(before.setpoint.linear().transpose() * after.setpoint.linear()).angle();
}

/// Compares row `last` with the one before it, and with the earlier ones from `first` on of the
/// same window: a jump may come in pieces.
void findJumps(const std::vector<ArmRow>& rows, std::size_t first, std::size_t last,
               HoldJudgement& judgement) {
  double time = 0;
  for (std::size_t i = last; i-- > first && time < kJumpTime;) {
    time += longestMotion(rows[i], rows[i + 1]);
    judgement.largest_jump =
        std::max(judgement.largest_jump, stepBetween(rows[i], rows[last]) - kFastest * time);
    judgement.largest_turn =
        std::max(judgement.largest_turn, turnBetween(rows[i], rows[last]) - kFastestTurn * time);
  }
}

std::string whyAtRest(bool enabled) {
  if (enabled) return "it never moved again";
  return "it never moved again, and was not enabled at the end: an arm whose drives fell silent "
         "stays in FAULT until a person enables or disables it";
}

}  // namespace

HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended) {
  HoldJudgement judgement;
  judgement.enabled_at_end = rows.empty() || rows.back().enabled;
  std::size_t lastBefore = 0;  // the break
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].stamp < broken) lastBefore = i;
    const double step = stepBetween(rows[i - 1], rows[i]);
    const double turn = turnBetween(rows[i - 1], rows[i]);
    if (step <= kStill && turn <= kUnturned) continue;
    if (rows[i].stamp < broken) {
      judgement.rested_before = secondsBetween(rows[i].stamp, broken);
      continue;
    }
    findJumps(rows, lastBefore, i, judgement);
    if (rows[i].stamp < mended) {
      judgement.held_after = secondsBetween(broken, rows[i].stamp);
    } else if (rows[i].enabled && !judgement.resumed_after) {
      judgement.resumed_after = secondsBetween(mended, rows[i].stamp);
    }
  }
  return judgement;
}

std::vector<std::string> violations(const HoldJudgement& judgement, const HoldBounds& bounds) {
  std::vector<std::string> found;
  if (!judgement.rested_before || *judgement.rested_before > kLongestRest) {
    found.push_back("it stood still before, so nobody can tell whether it held");
  }
  if (judgement.held_after > bounds.held_after) {
    found.push_back(sentence("it moved until %.0f ms after that, at most %.0f ms allowed",
                             1e3 * judgement.held_after, 1e3 * bounds.held_after));
  }
  if (!judgement.resumed_after) found.push_back(whyAtRest(judgement.enabled_at_end));
  if (judgement.largest_jump > kLargestJump) {
    found.push_back(sentence("its set-point jumped by %.1f mm, at most %.1f mm allowed",
                             1e3 * judgement.largest_jump, 1e3 * kLargestJump));
  }
  if (judgement.largest_turn > kLargestTurn) {
    found.push_back(sentence("its set-point turned by %.1f deg at once, at most %.1f deg allowed",
                             judgement.largest_turn / kDegree, kLargestTurn / kDegree));
  }
  return found;
}

}  // namespace robots
