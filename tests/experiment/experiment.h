#pragma once
// Runs trials, and finds the operator's own limit, each on a stepped clock of its own.

#include <cstdint>

#include "experiment/result.h"
#include "experiment/trial.h"

namespace experiment {

/// The process must have no stepped clock. Lets an operator place a knot over the link of the
/// trial, for kLength from when the guide begins. Equal trials have equal results.
Result run(const Trial& trial);
constexpr double kLength = 20;  ///< s

/// Says along which of the scene's axes: the strand hangs between the tips along the first, and
/// swings across it like a pendulum, which is slower.
enum class Axis : std::uint8_t { AlongStrand, AcrossStrand };

/// This is the limit with both inputs and without fixtures, over a link of constant delay.
struct Limit {
  double loop = 0;       ///< s: what the system delays the picture without a link, measured
  double byFormula = 0;  ///< s, round trip: pi / (2 w_c) - tau - loop
  double measured = 0;   ///< s, round trip: the longest with which the error of the knot dies out
};
/// It takes minutes of the clock, and some ten seconds.
Limit findLimit(Axis axis);

}  // namespace experiment
