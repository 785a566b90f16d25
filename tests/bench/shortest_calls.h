#pragma once
// These time calls that are long enough for a clock, one at a time.

#include <suture/base/time.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "bench/figures/statistics.h"

namespace bench {

/// Its costs are in us of wall time.
struct CallCosts {
  std::vector<double> shortest;  ///< the shortest of each case's five calls
  std::vector<double> every;     ///< every call, with what interrupted it
};

/// Calls `call(one)` five times for each of `count` cases that `next()` makes. The calls of a case
/// are some milliseconds apart, since what interrupts one does not last that long. `done(one)` sees
/// each case after its last.
template <class Next, class Call, class Done>
CallCosts shortestCalls(std::size_t count, const Next& next, const Call& call, const Done& done) {
  constexpr std::size_t kBatch = 1000;
  constexpr int kRepeats = 5;
  using Case = decltype(next());
  const auto inMicroseconds = [](suture::Duration cost) {
    return static_cast<double>(cost.count()) / kMicrosecond;
  };
  CallCosts costs;
  costs.shortest.reserve(count);
  costs.every.reserve(kRepeats * count);
  while (costs.shortest.size() < count) {
    std::vector<Case> batch;
    while (batch.size() < std::min(kBatch, count - costs.shortest.size())) batch.push_back(next());
    std::vector<suture::Duration> shortest(batch.size(), suture::Duration::max());
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const suture::Time begin = suture::now();
        call(batch[i]);
        const suture::Duration cost = suture::now() - begin;
        shortest[i] = std::min(shortest[i], cost);
        costs.every.push_back(inMicroseconds(cost));
      }
    }
    for (const Case& one : batch) done(one);
    for (const suture::Duration cost : shortest) costs.shortest.push_back(inMicroseconds(cost));
  }
  return costs;
}

}  // namespace bench
