#include "recorder/judge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using suture::Time;

// Is the shortest gap in the master's recording that interpolation must not bridge.
constexpr double kLongestGap = 0.05;  // s
// Is how much later than the row of its stamp a record may be written.
constexpr auto kPatience = std::chrono::milliseconds(200);
// The law's speed is measured over twice this; over one cycle it would be the noise of the
// encoders.
constexpr auto kHalfBase = std::chrono::milliseconds(10);

}  // namespace

Judge::Pose Judge::toPose(const Eigen::Isometry3d& pose) {
  return {pose.translation(), Quaterniond(pose.linear())};
}

Judge::Pose Judge::blend(const Pose& from, const Pose& to, double share) {
  return {from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
}

// This is the law a second time on purpose, because it checks that of the component.
Judge::Pose Judge::law(const FollowAnchors& anchors, const Pose& master) {
  const Pose master0 = toPose(anchors.master), slave0 = toPose(anchors.slave_setpoint);
  const Quaterniond view(anchors.view);
  const Vector3d moved = anchors.scale * (view * (master.p - master0.p));
  const Quaterniond turned = view * master.q * master0.q.conjugate() * view.conjugate();
  return {anchors.translation_locked ? slave0.p : slave0.p + moved,
          anchors.rotation_locked ? slave0.q : turned * slave0.q};
}

/// Returns the recorded master at `stamp`, between the two rows around it.
std::optional<Judge::Pose> Judge::masterAt(Time stamp) const {
  const auto after = std::lower_bound(master_.begin(), master_.end(), stamp,
                                      [](const ArmRow& row, Time t) { return row.stamp < t; });
  if (after == master_.end()) return std::nullopt;
  if (after->stamp == stamp) return toPose(after->measured);
  if (after == master_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap = secondsBetween(before->stamp, after->stamp);
  if (gap > kLongestGap) return std::nullopt;
  return blend(toPose(before->measured), toPose(after->measured),
               secondsBetween(before->stamp, stamp) / gap);
}

/// Returns the first entry after `stamp` at which following began.
Judge::Entry Judge::entryAfter(Time stamp) const {
  return std::upper_bound(followed_.begin(), followed_.end(), stamp,
                          [](Time t, const FollowAnchors& a) { return t < a.master_stamp; });
}

/// Returns false before following began, and while the slave is not enabled, until following begins
/// anew. That may have a stamp from before the slave was enabled, because the master's data are
/// older.
bool Judge::isFollowing(const ArmRow& row) {
  const auto next = entryAfter(row.goal_stamp);
  if (wasEnabled_ && !row.enabled) disabled_ = row.stamp;
  wasEnabled_ = row.enabled;
  return next != followed_.begin() && row.enabled && (!disabled_ || next != entryAfter(*disabled_));
}

/// Returns where the slave was told to be by data of time `stamp`.
std::optional<Judge::Pose> Judge::targetAt(Time stamp) const {
  const auto next = entryAfter(stamp);
  if (next == followed_.begin()) return std::nullopt;
  const auto pose = masterAt(stamp);
  if (!pose) return std::nullopt;
  return law(*std::prev(next), *pose);
}

void Judge::addMaster(const std::vector<ArmRow>& rows) {
  master_.insert(master_.end(), rows.begin(), rows.end());
}

void Judge::addFollowed(const std::vector<FollowAnchors>& followed) {
  followed_.insert(followed_.end(), followed.begin(), followed.end());
}

void Judge::addSlave(const std::vector<ArmRow>& rows) {
  waiting_.insert(waiting_.end(), rows.begin(), rows.end());
}

void Judge::advance() {
  while (!waiting_.empty() && !master_.empty() &&
         std::max(waiting_.front().stamp, waiting_.front().goal_stamp) + kPatience <
             master_.back().stamp) {
    judge(waiting_.front());
    forgetMasterBefore(waiting_.front().goal_stamp);
    waiting_.pop_front();
  }
}

// Keeps older rows for a while: a set-point that is held keeps an old stamp, and a later one may be
// a little older than the last.
void Judge::forgetMasterBefore(Time stamp) {
  while (!master_.empty() && master_.front().stamp + kPatience < stamp) master_.pop_front();
}

void Judge::judge(const ArmRow& row) {
  if (!isFollowing(row)) return expected_.reset();
  const Pose measured = toPose(row.measured);
  if (!expected_) {
    expected_ = measured;
    target_.reset();
    if (!start_) start_ = measured.p;
  } else if (target_) {
    follow(row, measured);
  }
  travel_ = std::max(travel_, (measured.p - *start_).norm());
  last_ = row.stamp;
  retarget(row);
}

void Judge::follow(const ArmRow& row, const Pose& measured) {
  const double seconds = secondsBetween(last_, row.stamp);
  const double share = timeConstant_ > 0 ? 1 - std::exp(-seconds / timeConstant_) : 1;
  expected_ = blend(*expected_, *target_, share);
  position_.push_back((measured.p - expected_->p).norm());
  orientation_.push_back(measured.q.angularDistance(expected_->q));
  // A pose that goes this share of the way to its goal in each cycle is this far behind an even
  // motion.
  const double behind = seconds / share;
  if (isNewTarget_) {
    compareAtEqualTime(row, measured, secondsBetween(targetStamp_, last_) + behind);
  }
}

void Judge::compareAtEqualTime(const ArmRow& row, const Pose& measured, double latency) {
  const FollowAnchors& anchors = *std::prev(entryAfter(row.goal_stamp));
  const auto before = masterAt(row.stamp - kHalfBase), now = masterAt(row.stamp),
             after = masterAt(row.stamp + kHalfBase);
  if (!before || !now || !after) return;
  const Vector3d way = law(anchors, *after).p - law(anchors, *before).p;
  equalTime_.push_back((measured.p - law(anchors, *now).p).norm());
  speedTimesLatency_.push_back(way.norm() / inSeconds(2 * kHalfBase) * latency);
}

void Judge::retarget(const ArmRow& row) {
  isNewTarget_ = row.goal_stamp > targetStamp_;
  targetStamp_ = row.goal_stamp;
  if (const auto next = targetAt(row.goal_stamp)) {
    target_ = next;
  } else {
    ++unmatched_;
  }
}

ErrorSummary Judge::recentPosition() {
  const auto from = position_.begin() + static_cast<std::ptrdiff_t>(reported_);
  reported_ = position_.size();
  return summarise({from, position_.end()});
}

Judgement Judge::finish() {
  for (const ArmRow& row : waiting_) judge(row);
  waiting_.clear();
  return {.position = summarise(position_),
          .orientation = summarise(orientation_),
          .equal_time = summarise(equalTime_),
          .speed_times_latency = summarise(speedTimesLatency_).mean,
          .travel = travel_,
          .compared = position_.size(),
          .unmatched = unmatched_};
}

Judgement judge(const std::vector<ArmRow>& master, const std::vector<FollowAnchors>& followed,
                const std::vector<ArmRow>& slave, double timeConstant) {
  Judge judge(timeConstant);
  judge.addMaster(master);
  judge.addFollowed(followed);
  judge.addSlave(slave);
  return judge.finish();
}

std::vector<std::string> violations(const Judgement& judgement, const JudgementBounds& bounds) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::vector<std::string> found;
  if (judgement.compared == 0) found.push_back("the slave never followed");
  if (judgement.position.p99 > bounds.position) {
    found.push_back(sentence("position error %.3f mm at p99, at most %.3f mm allowed",
                             1e3 * judgement.position.p99, 1e3 * bounds.position));
  }
  if (judgement.orientation.p99 > bounds.orientation) {
    found.push_back(sentence("orientation error %.3f deg at p99, at most %.3f deg allowed",
                             kDegrees * judgement.orientation.p99, kDegrees * bounds.orientation));
  }
  if (judgement.travel < bounds.travel) {
    found.push_back(sentence("the slave travelled %.1f mm, at least %.1f mm required",
                             1e3 * judgement.travel, 1e3 * bounds.travel));
  }
  const double cycles = static_cast<double>(judgement.compared + judgement.unmatched);
  if (static_cast<double>(judgement.unmatched) > bounds.unmatched * cycles) {
    found.push_back(sentence("%.0f of %.0f slave cycles have no recorded master",
                             static_cast<double>(judgement.unmatched), cycles));
  }
  return found;
}

}  // namespace robots
