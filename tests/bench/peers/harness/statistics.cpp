#include "harness/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace peers {

Statistics statisticsOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  // The least value that at least this part of all values does not exceed.
  const auto quantile = [&](double part) {
    const auto count =
        static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size())));
    return values[std::clamp<std::size_t>(count, 1, values.size()) - 1];
  };
  return {values.front(), quantile(0.5), quantile(0.99), quantile(0.999), values.back()};
}

}  // namespace peers
