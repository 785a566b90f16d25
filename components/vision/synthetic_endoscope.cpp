#include "vision/synthetic_endoscope.h"

#include "parameters/valid_time.h"

namespace robots {
namespace {

// The table keeps few pairs, because a row is megabytes and nobody reads an old one.
constexpr unsigned kPairs = 4;

// The strand keeps no more of its past.
constexpr suture::Duration kLongestLatency = std::chrono::milliseconds(500);

}  // namespace

SyntheticEndoscope::SyntheticEndoscope(const EndoscopeParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      painter_(CameraPair{.vergence = parameters.vergence}),
      sensor_(parameters.noise, parameters.blur),
      lost_(parameters.dropout) {
  requireTime("latency", parameters.latency,
              {.shortest = suture::Duration{0}, .longest = kLongestLatency});
  images_.keepState({.rows = kPairs});
}

/// Draws what nobody sees: Mesa compiles its programs with the first images, which on a busy
/// machine takes longer than clients wait for a cycle.
void SyntheticEndoscope::onStart() {
  constexpr double kReach = 0.01, kDepth = 0.1;  // m
  View view;
  view.strand.row(0).setLinSpaced(-kReach, kReach);
  view.strand.row(1).setZero();
  view.strand.row(2).setConstant(kDepth);
  for (const auto& [eye, image] : {std::pair(Eye::Left, &pair_.left), {Eye::Right, &pair_.right}}) {
    painter_.paint(eye, view, *image);
    image->valid = false;
  }
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
