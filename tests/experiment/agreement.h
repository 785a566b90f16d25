#pragma once
// Whether a trial in real time comes to what it comes to on the stepped clock.

#include <string>
#include <vector>

#include "experiment/real_time.h"
#include "experiment/trial.h"

namespace experiment {

/// A point of the grid, run both ways.
struct Point {
  Trial trial;
  RealTimeResult real;
  Result stepped;
};

/// Six of them: README.md says why these.
std::vector<Trial> realTimePoints();

/// By what share of the stepped figure the real one differs; 0 if both are none, infinite if one
/// is.
double differenceOfTime(const Point& point);
double differenceOfTracking(const Point& point);
/// Both within kAgrees, and the outcomes are equal.
bool agrees(const Point& point);
constexpr double kAgrees = 0.1;

/// Some lines for people: each figure in real time and on the stepped clock.
std::string describe(const Point& point);

}  // namespace experiment
