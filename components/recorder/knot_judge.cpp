#include "recorder/knot_judge.h"

#include <suture/base/time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "recorder/judging.h"
#include "timing/seconds.h"

namespace robots {
namespace {

using Eigen::Vector3d;
using Rows = std::vector<KnotRow>;

// In m: the knot may be this far from its target, and a sighting from the truth.
constexpr double kFarthest = 0.001;
constexpr double kLeastWay = 0.01;  // m
// Cameras may lose the knot for moments, but not for long.
constexpr double kLeastSighted = 0.9;
// The guide's process may end some moments before the recorder's.
constexpr double kLeastGuided = 0.5;
constexpr auto kEnd = std::chrono::milliseconds(500);
constexpr double kFarthestOutside = 0.002;  // m

Rows::const_iterator firstSince(const Rows& rows, suture::Time stamp) {
  return std::lower_bound(
      rows.begin(), rows.end(), stamp,
      [](const KnotRow& row, suture::Time wanted) { return row.strand.stamp < wanted; });
}

/// Returns the true knot at a stamp between two rows; none outside them.
std::optional<Vector3d> knotAt(const Rows& rows, suture::Time stamp) {
  const auto after = firstSince(rows, stamp);
  if (after == rows.begin() || after == rows.end()) return std::nullopt;
  const KnotRow& before = *std::prev(after);
  const double share = secondsBetween(before.strand.stamp, stamp) /
                       secondsBetween(before.strand.stamp, after->strand.stamp);
  return before.knot() + share * (after->knot() - before.knot());
}

/// Fills in what the last half second shows, guided or not.
void judgeEnd(const Rows& rows, const Vector3d& target, KnotJudgement& judgement) {
  if (rows.empty()) return;
  const auto first = firstSince(rows, rows.back().strand.stamp - kEnd);
  const auto count = static_cast<double>(rows.end() - first);
  for (auto row = first; row != rows.end(); ++row) {
    judgement.error += (row->knot() - target).norm() / count;
    judgement.guided_at_end += (row->guiding ? 1 : 0) / count;
  }
}

/// Fills in what all guided rows show.
void judgeGuided(const Rows& rows, const Vector3d& target, KnotJudgement& judgement) {
  std::vector<double> sightingErrors;
  std::size_t sighted = 0;
  for (const KnotRow& row : rows) {
    if (!row.guiding) continue;
    if (judgement.rows++ == 0) judgement.start = (row.knot() - target).norm();
    if (!row.sighting.valid) continue;
    ++sighted;
    if (const auto truth = knotAt(rows, row.sighting.stamp)) {
      sightingErrors.push_back((row.camera * row.sighting.knot - *truth).norm());
    }
  }
  if (judgement.rows > 0) {
    judgement.sighted = static_cast<double>(sighted) / static_cast<double>(judgement.rows);
  }
  judgement.sighting_error = summarise(std::move(sightingErrors)).p99;
}

/// Returns how far a knot is outside of the corridor, whose eight planes are about its circle, or
/// beyond the target.
double outsideOf(const KnotBounds& bounds, const Vector3d& target, const Vector3d& knot) {
  const Vector3d approach = bounds.approach.normalized(), left = target - knot;
  const double ahead = approach.dot(left);
  const double corner = 1 / std::cos(std::numbers::pi / 8);
  const double room = corner * (bounds.radius + bounds.slope * std::max(ahead, 0.0));
  return std::max(left.cross(approach).norm() - room, -ahead);
}

/// Fills in how far knot and tips were where the fixtures do not let them, in all guided rows.
void judgeBounds(const Rows& rows, const Vector3d& target, const KnotBounds& bounds,
                 KnotJudgement& judgement) {
  std::optional<double> atFirst;  // m outside: fixtures move nothing back
  for (const KnotRow& row : rows) {
    if (!row.guiding) continue;
    const Vector3d left = row.strand.nodes.col(0), right = row.strand.nodes.rightCols<1>();
    const double outside = outsideOf(bounds, target, row.knot());
    if (!atFirst) atFirst = std::max(outside, 0.0);
    const auto keepMost = [](std::optional<double>& most, double value) {
      most = std::max(most.value_or(value), value);
    };
    keepMost(judgement.outside, outside - *atFirst);
    keepMost(judgement.depth, row.tissue - std::min(left.z(), right.z()));
    keepMost(judgement.contact, bounds.separation - (left - right).norm());
  }
}

}  // namespace

KnotJudgement judgeKnot(const std::vector<KnotRow>& rows, const Vector3d& target,
                        const std::optional<KnotBounds>& bounds) {
  KnotJudgement judgement;
  if (bounds) judgeBounds(rows, target, *bounds, judgement);
  judgeEnd(rows, target, judgement);
  judgeGuided(rows, target, judgement);
  return judgement;
}

std::vector<std::string> violations(const KnotJudgement& judgement) {
  if (judgement.rows == 0) return {"the knot was never guided"};  // the rest says nothing then
  std::vector<std::string> found;
  if (judgement.guided_at_end < kLeastGuided) {
    found.push_back(
        sentence("the knot was guided for %.0f %% of the last half second, at least %.0f %% wanted",
                 1e2 * judgement.guided_at_end, 1e2 * kLeastGuided));
  }
  if (judgement.error > kFarthest) {
    found.push_back(sentence("the knot ended %.2f mm from its target, at most %.2f mm allowed",
                             1e3 * judgement.error, 1e3 * kFarthest));
  }
  const double way = judgement.start - judgement.error;
  if (way < kLeastWay) {
    found.push_back(sentence("the knot came %.1f mm nearer to its target, at least %.1f mm wanted",
                             1e3 * way, 1e3 * kLeastWay));
  }
  if (judgement.sighted < kLeastSighted) {
    found.push_back(
        sentence("the cameras saw the knot %.0f %% of the guided time, at least %.0f %% wanted",
                 1e2 * judgement.sighted, 1e2 * kLeastSighted));
  }
  if (judgement.sighting_error > kFarthest) {
    found.push_back(
        sentence("the cameras saw the knot %.2f mm from the truth at p99, at most %.2f mm allowed",
                 1e3 * judgement.sighting_error, 1e3 * kFarthest));
  }
  const auto require = [&](const std::optional<double>& outside, const char* format) {
    if (!outside || *outside <= kFarthestOutside) return;
    found.push_back(sentence(format, 1e3 * *outside, 1e3 * kFarthestOutside));
  };
  require(judgement.outside,
          "the knot was %.2f mm outside of its corridor, at most %.2f mm allowed");
  require(judgement.depth, "a tip was %.2f mm deep in the tissue, at most %.2f mm allowed");
  require(judgement.contact, "the tips were %.2f mm too near, at most %.2f mm allowed");
  return found;
}

}  // namespace robots
