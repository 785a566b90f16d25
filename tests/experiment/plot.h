#pragma once
// These draw the results of trials as curves over the delay of the link.

#include <filesystem>
#include <vector>

#include "experiment/experiment.h"
#include "experiment/result.h"
#include "experiment/trial.h"

namespace experiment {

struct TrialResult {
  Trial trial;
  Result result;
};

/// Draws a column for each kind of link among the results that has jitter or loss, but not both, or
/// has none: above the error of the knot, below the time to place it. Marks what Xu 2014 and
/// Nankaku 2022 found acceptable, and the operator's own limit. Throws suture::SetupError if the
/// file cannot be written.
void plot(const std::filesystem::path& file, const std::vector<TrialResult>& results,
          const Limit& limit);

}  // namespace experiment
