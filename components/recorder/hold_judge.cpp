#include "recorder/hold_judge.h"

#include <algorithm>
#include <cstddef>

#include "recorder/judging.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kStill = 1e-9;  // m
constexpr double kSoon = 0.5;    // s
constexpr double kJump = 0.003;  // m

/// Returns how far in m an arm may move from one row to the next, at the speed of a fast hand. Rows
/// that are far apart permit no more than a few cycles, because somebody stood still between them.
double farthestMotion(const ArmRow& before, const ArmRow& after) {
  constexpr double kFastest = 0.25;   // m/s
  constexpr double kLongest = 0.025;  // s
  return kFastest * std::min(secondsBetween(before.stamp, after.stamp), kLongest);
}

}  // namespace

HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended) {
  HoldJudgement judgement;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step =
        (rows[i].setpoint.translation() - rows[i - 1].setpoint.translation()).norm();
    if (step <= kStill) continue;
    if (rows[i].stamp < broken) {
      judgement.rested_before = secondsBetween(rows[i].stamp, broken);
      continue;
    }
    judgement.largest_jump =
        std::max(judgement.largest_jump, step - farthestMotion(rows[i - 1], rows[i]));
    if (rows[i].stamp < mended) {
      judgement.held_after = secondsBetween(broken, rows[i].stamp);
    } else if (!judgement.resumed_after) {
      judgement.resumed_after = secondsBetween(mended, rows[i].stamp);
    }
  }
  return judgement;
}

std::vector<std::string> violations(const HoldJudgement& judgement) {
  std::vector<std::string> found;
  if (!judgement.rested_before || *judgement.rested_before > kSoon) {
    found.push_back("it stood still before, so nobody can tell whether it held");
  }
  if (judgement.held_after > kSoon) {
    found.push_back(sentence("it moved until %.0f ms after that, at most %.0f ms allowed",
                             1e3 * judgement.held_after, 1e3 * kSoon));
  }
  if (!judgement.resumed_after) found.push_back("it never moved again");
  if (judgement.largest_jump > kJump) {
    found.push_back(sentence("its set-point jumped by %.1f mm, at most %.1f mm allowed",
                             1e3 * judgement.largest_jump, 1e3 * kJump));
  }
  return found;
}

}  // namespace robots
