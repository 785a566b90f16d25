#pragma once

#include <vector>

namespace peers {

struct Statistics {
  double minimum = 0, median = 0, p99 = 0, p999 = 0, maximum = 0;
};

/// Of no values all are 0.
Statistics statisticsOf(std::vector<double> values);

}  // namespace peers
