#include "harness/statistics.h"

#include <algorithm>
#include <cstddef>

namespace peers {

Statistics statisticsOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double part) {
    const auto place = static_cast<std::size_t>(part * static_cast<double>(values.size()));
    return values[std::min(values.size() - 1, place)];
  };
  return {values.front(), quantile(0.5), quantile(0.99), quantile(0.999), values.back()};
}

}  // namespace peers
