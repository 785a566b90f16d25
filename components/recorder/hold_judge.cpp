#include "recorder/hold_judge.h"

#include <algorithm>
#include <cstddef>

#include "recorder/judging.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr double kStill = 1e-9;       // m
constexpr double kUnturned = 1e-6;    // rad
constexpr double kLongestRest = 0.5;  // s, of an arm that moves

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

std::string whyAtRest(bool enabled) {
  if (enabled) return "it never moved again";
  return "it never moved again, and was not enabled at the end: an arm whose drives fell silent "
         "stays in FAULT until a person enables or disables it";
}

}  // namespace

HoldJudgement judgeHold(const std::vector<ArmRow>& rows, suture::Time broken, suture::Time mended) {
  HoldJudgement judgement;
  judgement.enabled_at_end = rows.empty() || rows.back().enabled;
  JumpWatch watch;  // from the last row before the break on
  if (!rows.empty()) watch.add(rows.front().setpoint, 0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].stamp < broken) watch.forget();
    watch.add(rows[i].setpoint, longestMotion(rows[i - 1], rows[i]));
    const double step = stepBetween(rows[i - 1], rows[i]);
    const double turn = turnBetween(rows[i - 1], rows[i]);
    if (step <= kStill && turn <= kUnturned) continue;
    if (rows[i].stamp < broken) {
      judgement.rested_before = secondsBetween(rows[i].stamp, broken);
      continue;
    }
    if (rows[i].stamp < mended) {
      judgement.held_after = secondsBetween(broken, rows[i].stamp);
    } else if (rows[i].enabled && !judgement.resumed_after) {
      judgement.resumed_after = secondsBetween(mended, rows[i].stamp);
    }
  }
  judgement.jumps = watch.jumps();
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
  const auto jumped = violations(judgement.jumps);
  found.insert(found.end(), jumped.begin(), jumped.end());
  return found;
}

}  // namespace robots
