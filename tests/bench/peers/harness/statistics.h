#pragma once

#include <vector>

namespace peers {

struct Statistics {
  double minimum = 0, median = 0, p99 = 0, p999 = 0, maximum = 0;
};

/// Returns all 0 if there are no values.
Statistics statisticsOf(std::vector<double> values);

}  // namespace peers
