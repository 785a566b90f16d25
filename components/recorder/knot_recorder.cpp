#include "recorder/knot_recorder.h"

namespace robots {
namespace {

// The ring holds five seconds at 50 rows a second, which is longer than a disk stalls.
constexpr std::size_t kRows = 256;

}  // namespace

KnotRecorder::KnotRecorder(const KnotRecorderParameters& parameters)
    : PeriodicTask({.period = parameters.period}), writer_(parameters.file, kRows) {
  guidance_.on().guidance_state(
      [this](const GuidanceState& state) { guiding_ = state == GuidanceState::Guiding; });
}

void KnotRecorder::run() {
  const auto strand = strand_.strand();
  const auto frames = registration_.frames();
  if (!strand || !strand->valid || strand->stamp == row_.strand.stamp || !frames) return;
  row_.strand = *strand;
  row_.camera = frames->camera;
  row_.tissue = frames->tissue;
  const auto sighting = vision_.sighting();
  row_.sighting = sighting ? *sighting : KnotSighting{};
  row_.guiding = guiding_ && guidance_.connected();
  (void)writer_.push(row_);  // it counts the rows for which it has no room
}

}  // namespace robots
