#pragma once
// The judges of recordings share how errors are summed up, and how a missed bound is told.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace robots {

struct ErrorSummary {
  double p50 = 0, p99 = 0, max = 0;
};

/// All zero if there are no errors.
inline ErrorSummary summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  return {at(0.5), at(0.99), errors.back()};
}

/// `format` is that of printf, for two doubles: what was found, and its bound.
inline std::string sentence(const char* format, double found, double bound) {
  char text[128];
  std::snprintf(text, sizeof text, format, found, bound);
  return text;
}

}  // namespace robots
