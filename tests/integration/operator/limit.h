#pragma once
// These tell with which delay of the picture an operator still closes a stable loop: by the
// formula, and by trying.

#include <suture/base/time.h>

#include <chrono>
#include <numbers>

#include "support/pass.h"
#include "surgeon/operator.h"
#include "timing/seconds.h"

namespace robots::test {

/// Returns a quarter of the period at the crossover frequency, less the operator's own delay and
/// the loop's, in s.
inline double limitByFormula(const OperatorParameters& parameters, double loop) {
  return std::numbers::pi / (2 * parameters.crossover_frequency) - inSeconds(parameters.delay) -
         loop;
}

/// Tells if a swing gets smaller. `error()` is how far the loop is from its rest at that moment.
/// This takes 33 s of a stepped clock.
template <class Error>
bool diesOut(const Error& error) {
  const auto swing = [&] {
    double squares = 0;
    for (int i = 0; i < 150; ++i) {
      suture::pass(std::chrono::milliseconds(100));
      squares += error() * error();
    }
    return squares;
  };
  suture::pass(std::chrono::seconds(3));
  const double early = swing();
  return swing() < early;
}

/// Returns the longest delay for which `isStable(delay)` holds, less `resolution` at most; it is at
/// least `stable`, and less than `unstable`.
template <class IsStable>
suture::Duration longestStable(const IsStable& isStable, suture::Duration stable,
                               suture::Duration unstable, suture::Duration resolution) {
  while (unstable - stable > resolution) {
    const suture::Duration middle = (stable + unstable) / 2;
    (isStable(middle) ? stable : unstable) = middle;
  }
  return stable;
}

}  // namespace robots::test
