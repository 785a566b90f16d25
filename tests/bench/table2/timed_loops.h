#pragma once
// Costs too small for a clock: the mean over a loop, many times.

#include <suture/base/time.h>

#include <cstddef>
#include <vector>

#include "bench/statistics.h"

namespace bench {

/// Keeps the compiler from removing what leads to `value`.
template <class T>
void keep(T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// ns a call of `work`: statistics over `loops` loops of `length` calls each, after one that warms
/// up.
template <class Work>
Statistics timedLoops(std::size_t loops, std::size_t length, const Work& work) {
  std::vector<double> means;
  for (std::size_t loop = 0; loop <= loops; ++loop) {
    const suture::Time begin = suture::now();
    for (std::size_t i = 0; i < length; ++i) work();
    const auto took = static_cast<double>((suture::now() - begin).count());
    if (loop > 0) means.push_back(took / static_cast<double>(length));
  }
  return statisticsOf(std::move(means));
}

}  // namespace bench
