#pragma once
// The judges of recordings share this: how errors are summed up, and how a missed bound is
// reported.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace robots {

struct ErrorSummary {
  double p50 = 0, p99 = 0, max = 0, mean = 0;
};

/// Returns all zeros if there are no errors.
inline ErrorSummary summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  const double count = static_cast<double>(errors.size());
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * (count - 1))];
  };
  return {at(0.5), at(0.99), errors.back(), mean};
}

/// Returns a sentence about a missed bound. `format` is that of printf, for two doubles: what was
/// found, and its bound.
inline std::string sentence(const char* format, double found, double bound) {
  char text[128];
  std::snprintf(text, sizeof text, format, found, bound);
  return text;
}

}  // namespace robots
