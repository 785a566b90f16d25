#include "bench/figures/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bench {
namespace {

double percentile(const std::vector<double>& sorted, double fraction) {
  const auto rank =
      static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

double deviation(const std::vector<double>& samples, double mean) {
  if (samples.size() < 2) return 0;
  const double squares = std::accumulate(
      samples.begin(), samples.end(), 0.0,
      [mean](double sum, double sample) { return sum + (sample - mean) * (sample - mean); });
  return std::sqrt(squares / static_cast<double>(samples.size() - 1));
}

}  // namespace

Statistics statisticsOf(std::vector<double> samples) {
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const double mean =
      std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
  return {.count = samples.size(),
          .mean = mean,
          .std = deviation(samples, mean),
          .min = samples.front(),
          .p50 = percentile(samples, 0.5),
          .p99 = percentile(samples, 0.99),
          .p999 = percentile(samples, 0.999),
          .max = samples.back()};
}

std::vector<double> inUnits(const std::vector<std::int64_t>& nanoseconds, double unitNanoseconds) {
  std::vector<double> converted;
  converted.reserve(nanoseconds.size());
  for (const std::int64_t value : nanoseconds) {
    converted.push_back(static_cast<double>(value) / unitNanoseconds);
  }
  return converted;
}

}  // namespace bench
