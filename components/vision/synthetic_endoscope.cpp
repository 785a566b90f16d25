#include "vision/synthetic_endoscope.h"

namespace robots {

SyntheticEndoscope::SyntheticEndoscope(const EndoscopeParameters& parameters)
    : PeriodicTask({.period = parameters.period}), painter_(CameraPair{}, parameters.noise) {}

void SyntheticEndoscope::run() {
  const auto strand = strand_.strand();
  const auto frames = registration_.frames();
  if (!strand || !strand->valid || !frames) {
    pair_.left.valid = pair_.right.valid = false;
    return;
  }
  const Strand::Nodes seen = frames->camera.inverse() * strand->nodes;
  if (seen.row(2).minCoeff() < CameraPair::kNearest) {
    pair_.left.valid = pair_.right.valid = false;
    return;
  }
  painter_.paint(Eye::Left, seen, pair_.left);
  painter_.paint(Eye::Right, seen, pair_.right);
  pair_.left.stamp = pair_.right.stamp = strand->stamp;
}

}  // namespace robots
