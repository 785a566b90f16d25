#include "experiment/result.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "recorder/judging.h"

namespace experiment {
namespace {

using Moments = std::vector<Moment>;

constexpr double kEnd = 0.5;       // s
constexpr double kLeastEnd = 0.5;  // share of the last half second that is guided
constexpr double kGrows = 1.1;     // a swing that is so many times the one before

bool isPlaced(const Moment& moment) { return moment.error.norm() <= kPlaced; }

/// The mean of `figure` over the last half second.
template <class Figure>
double atEnd(const Moments& moments, const Figure& figure) {
  const std::size_t count = std::min(momentsIn(kEnd), moments.size());
  double sum = 0;
  for (auto one = moments.end() - static_cast<std::ptrdiff_t>(count); one != moments.end(); ++one) {
    sum += figure(*one);
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

/// Returns the seconds until the knot is placed for kStaysPlaced.
std::optional<double> timeToPlace(const Moments& moments) {
  std::size_t placed = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    placed = isPlaced(moments[i]) ? placed + 1 : 0;
    if (placed == momentsIn(kStaysPlaced)) {
      return static_cast<double>(i + 1 - placed) * kMomentLength;
    }
  }
  return std::nullopt;
}

/// Returns the swing peak to peak along the widest axis, m, in the given quarter of the time, of 0
/// to 3.
double swingIn(const Moments& moments, std::size_t quarter) {
  const std::size_t first = moments.size() * quarter / 4, end = moments.size() * (quarter + 1) / 4;
  if (first == end) return 0;
  Eigen::Vector3d least = moments[first].error, most = least;
  for (std::size_t i = first; i < end; ++i) {
    least = least.cwiseMin(moments[i].error);
    most = most.cwiseMax(moments[i].error);
  }
  return (most - least).maxCoeff();
}

Outcome outcomeOf(const Moments& moments, const Result& result) {
  if (atEnd(moments, [](const Moment& one) { return one.guided ? 1 : 0; }) < kLeastEnd) {
    return Outcome::Unguided;
  }
  if (result.time && result.error <= kPlaced) return Outcome::Placed;
  if (result.swing <= 2 * kPlaced) return Outcome::Misses;
  return result.swing > kGrows * swingIn(moments, 2) ? Outcome::Diverges : Outcome::Oscillates;
}

}  // namespace

const char* toString(Outcome outcome) {
  switch (outcome) {
    case Outcome::Placed: return "placed";
    case Outcome::Oscillates: return "oscillates";
    case Outcome::Diverges: return "diverges";
    case Outcome::Misses: return "misses";
    case Outcome::Unguided: return "unguided";
  }
  return "";
}

Result judge(const Moments& moments) {
  Result result;
  if (moments.empty()) return result;
  result.error = atEnd(moments, [](const Moment& one) { return one.error.norm(); });
  result.time = timeToPlace(moments);
  result.swing = swingIn(moments, 3);
  std::vector<double> tracking;
  double guided = 0;
  for (const Moment& one : moments) {
    if (!one.guided) continue;
    guided += 1;
    tracking.insert(tracking.end(), {one.left, one.right});
  }
  result.guided = guided / static_cast<double>(moments.size());
  const robots::ErrorSummary summary = robots::summarise(std::move(tracking));
  result.tracking50 = summary.p50;
  result.tracking99 = summary.p99;
  result.outcome = outcomeOf(moments, result);
  return result;
}

}  // namespace experiment
