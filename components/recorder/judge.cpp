#include "recorder/judge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace robots {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using suture::Time;

// A hole in the master's recording that interpolation must not bridge.
constexpr double kLongestGap = 0.05;  // s

struct Pose {
  Vector3d p;
  Quaterniond q;
};

Pose toPose(const Eigen::Isometry3d& pose) {
  return {pose.translation(), Quaterniond(pose.linear())};
}

double secondsBetween(Time from, Time to) {
  return std::chrono::duration<double>(to - from).count();
}

Pose blend(const Pose& from, const Pose& to, double share) {
  return {from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
}

/// The recorded master at `stamp`, between the two rows around it.
std::optional<Pose> masterAt(const std::vector<ArmRow>& master, Time stamp) {
  const auto after = std::lower_bound(master.begin(), master.end(), stamp,
                                      [](const ArmRow& row, Time t) { return row.stamp < t; });
  if (after == master.end()) return std::nullopt;
  if (after->stamp == stamp) return toPose(after->measured);
  if (after == master.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap = secondsBetween(before->stamp, after->stamp);
  if (gap > kLongestGap) return std::nullopt;
  return blend(toPose(before->measured), toPose(after->measured),
               secondsBetween(before->stamp, stamp) / gap);
}

/// The law, written down a second time on purpose: this is what the component's own is checked
/// against.
Pose law(const FollowAnchors& anchors, const Pose& master) {
  const Pose master0 = toPose(anchors.master), slave0 = toPose(anchors.slave_setpoint);
  return {slave0.p + anchors.scale * (master.p - master0.p),
          master.q * master0.q.conjugate() * slave0.q};
}

/// Where the slave was told to be by data of time `stamp`.
std::optional<Pose> targetAt(const std::vector<ArmRow>& master,
                             const std::vector<FollowAnchors>& followed, Time stamp) {
  const auto next =
      std::upper_bound(followed.begin(), followed.end(), stamp,
                       [](Time t, const FollowAnchors& a) { return t < a.master_stamp; });
  if (next == followed.begin()) return std::nullopt;
  const auto pose = masterAt(master, stamp);
  if (!pose) return std::nullopt;
  return law(*std::prev(next), *pose);
}

ErrorSummary summarise(std::vector<double>& errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  return {at(0.5), at(0.99), errors.back()};
}

std::string sentence(const char* format, double found, double bound) {
  char text[128];
  std::snprintf(text, sizeof text, format, found, bound);
  return text;
}

}  // namespace

Judgement judge(const std::vector<ArmRow>& master, const std::vector<FollowAnchors>& followed,
                const std::vector<ArmRow>& slave, double timeConstant) {
  Judgement judgement;
  std::vector<double> position, orientation;
  std::optional<Pose> target;    // what acts on the slave since its last cycle
  std::optional<Pose> expected;  // where the slave should be
  Time last;
  Vector3d start = Vector3d::Zero();
  for (const ArmRow& row : slave) {
    if (followed.empty() || row.goal_stamp < followed.front().master_stamp) continue;
    const Pose measured = toPose(row.measured);
    if (!expected) {
      expected = measured;
      start = measured.p;
    } else if (target) {
      const double share = 1 - std::exp(-secondsBetween(last, row.stamp) / timeConstant);
      expected = blend(*expected, *target, share);
      position.push_back((measured.p - expected->p).norm());
      orientation.push_back(measured.q.angularDistance(expected->q));
    }
    judgement.travel = std::max(judgement.travel, (measured.p - start).norm());
    last = row.stamp;
    const auto next = targetAt(master, followed, row.goal_stamp);
    if (next) {
      target = next;
    } else {
      ++judgement.unmatched;
    }
  }
  judgement.compared = position.size();
  judgement.position = summarise(position);
  judgement.orientation = summarise(orientation);
  return judgement;
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
