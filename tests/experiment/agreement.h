#pragma once
// This tells if a trial in real time comes to what it comes to on the stepped clock.

#include <string>
#include <vector>

#include "experiment/real_time.h"
#include "experiment/trial.h"

namespace experiment {

/// This is a point of the grid, run both ways with equal seeds: it has a result of each way for
/// each seed.
struct Point {
  Trial trial;
  std::vector<Result> real, stepped;
  std::uint64_t packets = 0, lost = 0;  ///< in real time
};

/// Six of them, and how many seeds each is run with: README.md says why these.
std::vector<Trial> realTimePoints();
constexpr std::uint32_t kSeeds = 3;

/// Returns what is compared at a point: with fixtures the time until the knot is placed, without
/// them the median tracking error, each the mean of all seeds. README.md says why not the other
/// one.
double figureOf(const Trial& trial, const std::vector<Result>& results);
/// Returns by what share of the stepped figure the real one differs; infinite if a knot is not
/// placed.
double difference(const Point& point);
/// Returns true if the figures differ by kAgrees at most, and the knot is placed each time.
bool agrees(const Point& point);
constexpr double kAgrees = 0.1;

/// Returns some lines for people: each result in real time and on the stepped clock.
std::string describe(const Point& point);

}  // namespace experiment
