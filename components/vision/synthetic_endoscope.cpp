#include "vision/synthetic_endoscope.h"

namespace robots {
namespace {

// The table keeps few pairs, because a row is megabytes and nobody reads an old one.
constexpr unsigned kPairs = 4;

}  // namespace

SyntheticEndoscope::SyntheticEndoscope(const EndoscopeParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      painter_(CameraPair{.vergence = parameters.vergence}),
      sensor_(parameters.noise, parameters.blur),
      lost_(parameters.dropout) {
  images_.keepState({.rows = kPairs});
}

void SyntheticEndoscope::run() {
  if (lost_(random_)) return;  // no client is told: the last pair stays the last
  const auto strand = strand_.strand.delayed(parameters_.latency);
  const auto frames = registration_.frames.delayed(parameters_.latency);  // the camera may move
  pair_.left.valid = pair_.right.valid = false;
  if (!strand || !strand->valid || !frames) return;
  const View view = seenFrom(frames->camera, strand->nodes, frames->tissue);
  if (view.strand.row(2).minCoeff() < CameraPair::kNearest) return;
  expose(Eye::Left, view, strand->stamp, pair_.left);
  expose(Eye::Right, view, strand->stamp, pair_.right);
}

void SyntheticEndoscope::expose(Eye eye, const View& view, suture::Time exposed,
                                ImageFrame& image) {
  painter_.paint(eye, view, image);
  sensor_.expose(image);
  image.stamp = exposed;
}

}  // namespace robots
