#include "experiment/table.h"

#include <fmt/format.h>

#include "timing/seconds.h"

namespace experiment {

std::string header() {
  return "round_trip_ms,jitter_percent,loss_percent,fixtures,inputs,seed,knot_error_mm,"
         "time_to_place_s,tracking_p50_mm,tracking_p99_mm,swing_mm,guided_percent,outcome";
}

std::string row(const Trial& trial, const Result& result) {
  const std::string time = result.time ? fmt::format("{:.3f}", *result.time) : "";
  return fmt::format("{:.0f},{:.0f},{:.0f},{},{},{},{:.3f},{},{:.3f},{:.3f},{:.3f},{:.1f},{}",
                     1e3 * robots::inSeconds(trial.link.roundTrip), 1e2 * trial.link.jitter,
                     1e2 * trial.link.loss, trial.fixtures ? "on" : "off",
                     trial.inputs == Inputs::Two ? 2 : 1, trial.seed, 1e3 * result.error, time,
                     1e3 * result.tracking50, 1e3 * result.tracking99, 1e3 * result.swing,
                     1e2 * result.guided, toString(result.outcome));
}

}  // namespace experiment
