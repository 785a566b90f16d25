#include "08_bimanual_knot/knot_display.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace watching {
namespace {

const char* toString(robots::GuidanceState state) {
  switch (state) {
    case robots::GuidanceState::Preparing: return "the arms are being prepared";
    case robots::GuidanceState::Blind: return "nobody sees the knot: both slaves hold";
    case robots::GuidanceState::Guiding: return "both hands are guided";
    case robots::GuidanceState::Disabled: return "guidance is disabled";
    case robots::GuidanceState::Clutched: return "the clutch is pressed: both slaves hold";
  }
  return "?";
}

}  // namespace

KnotDisplay::KnotDisplay() : PeriodicTask({.period = std::chrono::milliseconds(500)}) {}

void KnotDisplay::run() {
  const auto state = guidance_.guidance_state();
  const auto progress = guidance_.progress();
  if (!state || !progress) return;
  std::printf("%s", toString(*state));
  if (progress->valid) {
    const double beside = progress->lateral_error;
    std::printf(": the knot is %.1f mm from its target, %.1f mm beside its line",
                1e3 * std::hypot(progress->distance_to_target, beside), 1e3 * beside);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace watching
