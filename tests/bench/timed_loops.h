#pragma once
// These measure costs that are too small for a clock, as the mean over a loop, many times.

#include <cstddef>
#include <ctime>
#include <vector>

#include "bench/figures/statistics.h"

namespace bench {

/// Keeps the compiler from removing what leads to `value`.
template <class T>
void keep(T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Returns the processor time of the calling thread, ns: while others have the processor it stands
/// still.
inline double threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

/// ns of processor time a call of `work`: statistics over `loops` loops of `length` calls each,
/// after one that warms up.
template <class Work>
Statistics timedLoops(std::size_t loops, std::size_t length, const Work& work) {
  std::vector<double> means;
  for (std::size_t loop = 0; loop <= loops; ++loop) {
    const double begin = threadTime();
    for (std::size_t i = 0; i < length; ++i) work();
    const double took = threadTime() - begin;
    if (loop > 0) means.push_back(took / static_cast<double>(length));
  }
  return statisticsOf(std::move(means));
}

}  // namespace bench
