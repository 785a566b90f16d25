#include "recorder/knot_judge.h"

#include <suture/base/time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "arm/seconds.h"
#include "strand/strand.h"

namespace robots {
namespace {

using Eigen::Vector3d;

constexpr double kBound = 0.001;    // m from the target
constexpr double kLeastWay = 0.01;  // m
constexpr auto kEnd = std::chrono::milliseconds(500);

Vector3d knotOf(const KnotRow& row) { return row.strand.nodes.col(Strand::kKnot); }

/// The true knot at a stamp between two rows; none outside them.
std::optional<Vector3d> knotAt(const std::vector<KnotRow>& rows, suture::Time stamp) {
  const auto after = std::lower_bound(
      rows.begin(), rows.end(), stamp,
      [](const KnotRow& row, suture::Time wanted) { return row.strand.stamp < wanted; });
  if (after == rows.begin() || after == rows.end()) return std::nullopt;
  const KnotRow& before = *std::prev(after);
  const double share = secondsBetween(before.strand.stamp, stamp) /
                       secondsBetween(before.strand.stamp, after->strand.stamp);
  return knotOf(before) + share * (knotOf(*after) - knotOf(before));
}

double percentile99(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.99 * (values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

KnotJudgement judgeKnot(const std::vector<KnotRow>& rows, const Vector3d& target) {
  KnotJudgement judgement;
  std::vector<double> sightingErrors;
  double sum = 0;
  std::size_t last = 0, sighted = 0;
  for (const KnotRow& row : rows) {
    if (row.strand.stamp >= rows.back().strand.stamp - kEnd) {
      sum += (knotOf(row) - target).norm();
      ++last;
    }
    if (!row.guiding) continue;
    if (judgement.rows++ == 0) judgement.start = (knotOf(row) - target).norm();
    if (!row.sighting.valid) continue;
    ++sighted;
    if (const auto truth = knotAt(rows, row.sighting.stamp)) {
      sightingErrors.push_back((row.camera * row.sighting.knot - *truth).norm());
    }
  }
  if (last > 0) judgement.error = sum / static_cast<double>(last);
  if (judgement.rows > 0) {
    judgement.sighted = static_cast<double>(sighted) / static_cast<double>(judgement.rows);
  }
  judgement.sighting_error = percentile99(sightingErrors);
  return judgement;
}

std::vector<std::string> violations(const KnotJudgement& judgement) {
  std::vector<std::string> found;
  const auto sentence = [](const char* format, double value, double bound) {
    char text[128];
    std::snprintf(text, sizeof(text), format, 1e3 * value, 1e3 * bound);
    return std::string(text);
  };
  if (judgement.rows == 0) found.push_back("the knot was never guided");
  if (judgement.error > kBound) {
    found.push_back(sentence("the knot ended %.2f mm from its target, at most %.2f mm allowed",
                             judgement.error, kBound));
  }
  if (judgement.start - judgement.error < kLeastWay) {
    found.push_back(sentence("the knot came %.1f mm nearer to its target, at least %.1f mm wanted",
                             judgement.start - judgement.error, kLeastWay));
  }
  return found;
}

}  // namespace robots
