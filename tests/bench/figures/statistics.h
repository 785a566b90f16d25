#pragma once
// These are what a figure says about many samples.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Its numbers are in the unit of the samples, and all zero if there are none.
struct Statistics {
  std::size_t count = 0;
  double mean = 0, std = 0, min = 0, p50 = 0, p99 = 0, p999 = 0, max = 0;
};

/// Percentiles are samples (nearest rank), not interpolations; the deviation is that of a sample.
Statistics statisticsOf(std::vector<double> samples);

/// Returns durations in nanoseconds as units of `unitNanoseconds`.
std::vector<double> inUnits(const std::vector<std::int64_t>& nanoseconds, double unitNanoseconds);

constexpr double kMicrosecond = 1e3;
constexpr double kMillisecond = 1e6;

}  // namespace bench
