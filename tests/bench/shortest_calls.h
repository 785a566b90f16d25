#pragma once
// Calls that are long enough for a clock, one at a time.

#include <suture/base/time.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "bench/statistics.h"

namespace bench {

/// us of each of `count` cases that `next()` makes, in wall time: the shortest of five calls of
/// `call(one)`. These are some milliseconds apart, since what interrupts one does not last that
/// long. `done(one)` sees each case after its last.
template <class Next, class Call, class Done>
std::vector<double> shortestCalls(std::size_t count, const Next& next, const Call& call,
                                  const Done& done) {
  constexpr std::size_t kBatch = 1000;
  constexpr int kRepeats = 5;
  using Case = decltype(next());
  std::vector<double> costs;
  costs.reserve(count);
  while (costs.size() < count) {
    std::vector<Case> batch;
    while (batch.size() < std::min(kBatch, count - costs.size())) batch.push_back(next());
    std::vector<suture::Duration> shortest(batch.size(), suture::Duration::max());
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const suture::Time begin = suture::now();
        call(batch[i]);
        shortest[i] = std::min(shortest[i], suture::now() - begin);
      }
    }
    for (const Case& one : batch) done(one);
    for (const suture::Duration cost : shortest) {
      costs.push_back(static_cast<double>(cost.count()) / kMicrosecond);
    }
  }
  return costs;
}

}  // namespace bench
