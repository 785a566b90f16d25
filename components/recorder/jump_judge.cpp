#include "recorder/jump_judge.h"

#include <algorithm>
#include <cstddef>

#include "recorder/judging.h"
#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Vector3d;

// In s: teleoperations and guides act on data that are at most 20 ms old, and begin anew after a
// longer delay of their own.
constexpr double kLongestMotion = 0.025;
constexpr std::size_t kPath = 512;         // set-points
constexpr double kFarthestAstray = 0.005;  // m

double distanceToLine(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0;
  return (point - from - share * way).norm();
}

}  // namespace

void JumpJudge::add(const std::vector<ArmRow>& rows) {
  for (const ArmRow& row : rows) add(row);
}

/// The set-point of an arm that is not enabled goes where its joints are moved; the first one that
/// it obeys again is compared with the last of those.
void JumpJudge::add(const ArmRow& row) {
  if (!row.enabled) watch_.forget();
  watch_.add(row.setpoint, motionUntil(row));
  last_ = row;
  path_.push_back(row.setpoint.translation());
  if (path_.size() > kPath) path_.pop_front();
  astray_ = std::max(astray_, fromPath(row.measured.translation()));
}

double JumpJudge::motionUntil(const ArmRow& row) const {
  if (!last_) return 0;
  const double goals = secondsBetween(last_->goal_stamp, row.goal_stamp);
  return std::max(secondsBetween(last_->stamp, row.stamp), std::min(goals, kLongestMotion));
}

/// Looks from the last set-point backwards, and no further once it is nearer than another tip was.
double JumpJudge::fromPath(const Vector3d& tip) const {
  double nearest = (tip - path_.back()).norm();
  for (std::size_t i = path_.size() - 1; i > 0 && nearest > astray_; --i) {
    nearest = std::min(nearest, distanceToLine(tip, path_[i - 1], path_[i]));
  }
  return nearest;
}

std::vector<std::string> violations(const JumpJudgement& judgement) {
  auto found = violations(judgement.setpoint);
  if (judgement.astray > kFarthestAstray) {
    found.push_back(
        sentence("it was %.1f mm from the path of its set-points, at most %.1f mm allowed",
                 1e3 * judgement.astray, 1e3 * kFarthestAstray));
  }
  return found;
}

}  // namespace robots
