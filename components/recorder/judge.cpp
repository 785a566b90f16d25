#include "recorder/judge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using suture::Time;

// Interpolation bridges no longer gap than this in the master's recording.
constexpr double kLongestGap = 0.05;  // s
// A record may be written this much later than the row of its stamp.
constexpr auto kPatience = std::chrono::milliseconds(200);
// A slave that gets no new goal is still thought to follow for this long.
constexpr auto kLongestWithoutGoal = std::chrono::milliseconds(50);
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

/// Returns false if the slave has got no new goal for a while.
bool Judge::getsGoals(const ArmRow& row) {
  if (std::exchange(goal_, row.goal_stamp) != row.goal_stamp) gotGoal_ = row.stamp;
  return row.stamp - gotGoal_ <= kLongestWithoutGoal;
}

void Judge::addMaster(const std::vector<ArmRow>& rows) {
  if (!rows.empty()) recordedUntil_ = std::max(recordedUntil_, rows.back().stamp);
  master_.insert(master_.end(), rows.begin(), rows.end());
}

void Judge::addFollowed(const std::vector<FollowAnchors>& followed) {
  followed_.insert(followed_.end(), followed.begin(), followed.end());
}

void Judge::addSlave(const std::vector<ArmRow>& rows) {
  if (!rows.empty()) recordedUntil_ = std::max(recordedUntil_, rows.back().stamp);
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
  const bool getsGoals = this->getsGoals(row), isFollowing = this->isFollowing(row);
  followedTime_.add(row.stamp, getsGoals && isFollowing);
  if (!isFollowing) return expected_.reset();
  const Pose measured = toPose(row.measured);
  if (!expected_) {
    expected_ = measured;
    targets_.clear();
    if (!start_) start_ = measured.p;
  } else if (!targets_.empty()) {
    follow(row, measured);
  }
  travel_ = std::max(travel_, (measured.p - *start_).norm());
  last_ = row.stamp;
  retarget(row);
}

void Judge::follow(const ArmRow& row, const Pose& measured) {
  moveExpected(row.stamp);
  const double error = (measured.p - expected_->p).norm();
  position_.add(error);
  recent_.add(error);
  orientation_.add(measured.q.angularDistance(expected_->q));
  const Acting& target = targets_.front();
  const double acted = secondsBetween(target.since, row.stamp);
  if (!target.isNew || acted <= 0) return;
  // A pose that goes a share of the way to its goal in each cycle is that far behind an even
  // motion.
  const double behind = acted / shareIn(acted);
  compareAtEqualTime(row, measured, secondsBetween(target.stamp, target.since) + behind);
}

/// Returns which share of its way to the target a slave goes in that time.
double Judge::shareIn(double seconds) const {
  return lag_.time_constant > 0 ? 1 - std::exp(-seconds / lag_.time_constant) : 1;
}

/// Moves where the slave should be on from its last cycle to one at `until`, through the targets
/// that acted meanwhile. Drives begin to act on a target in one of their cycles, which are not
/// quite a period apart.
void Judge::moveExpected(Time until) {
  for (Acting& target : targets_) {
    if (std::abs(secondsBetween(target.since, until)) <= lag_.delay / 2) target.since = until;
  }
  Time from = last_;
  while (targets_.size() > 1 && targets_[1].since < until) {
    const Time next = std::max(from, targets_[1].since);
    approach(targets_.front().target, secondsBetween(std::exchange(from, next), next));
    targets_.pop_front();
  }
  approach(targets_.front().target, secondsBetween(from, until));
}

void Judge::approach(const Pose& target, double seconds) {
  if (seconds > 0) expected_ = blend(*expected_, target, shareIn(seconds));
}

void Judge::compareAtEqualTime(const ArmRow& row, const Pose& measured, double latency) {
  const FollowAnchors& anchors = *std::prev(entryAfter(row.goal_stamp));
  const auto before = masterAt(row.stamp - kHalfBase), now = masterAt(row.stamp),
             after = masterAt(row.stamp + kHalfBase);
  if (!before || !now || !after) return;
  const Vector3d way = law(anchors, *after).p - law(anchors, *before).p;
  equalTime_.add((measured.p - law(anchors, *now).p).norm());
  speedTimesLatency_.add(way.norm() / inSeconds(2 * kHalfBase) * latency);
}

void Judge::retarget(const ArmRow& row) {
  const bool isNew = row.goal_stamp > targetStamp_;
  targetStamp_ = row.goal_stamp;
  if (const auto target = targetAt(row.goal_stamp)) {
    const auto delay = std::chrono::duration<double>(lag_.delay);
    const Time since = row.stamp + std::chrono::duration_cast<suture::Duration>(delay);
    targets_.push_back({since, row.goal_stamp, *target, isNew});
  } else {
    ++unmatched_;
  }
}

std::optional<ErrorSummary> Judge::recentPosition() {
  const ErrorHistogram recent = std::exchange(recent_, {});
  if (recent.count() == 0) return std::nullopt;
  return recent.summary();
}

Judgement Judge::finish(const Duty& duty) {
  for (const ArmRow& row : waiting_) judge(row);
  waiting_.clear();
  return {.position = position_.summary(),
          .orientation = orientation_.summary(),
          .equal_time = equalTime_.summary(),
          .speed_times_latency = speedTimesLatency_.summary().mean,
          .travel = travel_,
          .followed = followedTime_.until(duty.end.value_or(recordedUntil_), duty.excused),
          .compared = position_.count(),
          .unmatched = unmatched_};
}

Judgement judge(const std::vector<ArmRow>& master, const std::vector<FollowAnchors>& followed,
                const std::vector<ArmRow>& slave, const DeclaredLag& lag) {
  Judge judge(lag);
  judge.addMaster(master);
  judge.addFollowed(followed);
  judge.addSlave(slave);
  return judge.finish();
}

std::vector<std::string> violations(const Judgement& judgement, const JudgementBounds& bounds) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::vector<std::string> found;
  if (judgement.compared == 0) {
    found.push_back("the slave never followed");
  } else if (const FollowedShare& followed = judgement.followed; followed.share < bounds.followed) {
    found.push_back(
        sentence("the slave followed for %.0f %% of the time, at least %.0f %% required: ",
                 100 * followed.share, 100 * bounds.followed) +
        sentence("not from %.1f to %.1f s after it began", followed.missing_from,
                 followed.missing_until));
  }
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
