#include "strand/strand_simulation.h"

#include <algorithm>

#include "timing/seconds.h"

namespace robots {
namespace {

static_assert(Strand::kNodes == decltype(StrandState::nodes)::ColsAtCompileTime);

// Bounds a step, however long the task did not run, because the strand need not catch up with a
// debugger.
constexpr double kLongestStep = 0.02;  // s
// Tips that are nearer than this belong to arms that are not registered, and a strand between them
// has no direction.
constexpr double kLeastSpan = 0.001;  // m
// The table keeps this many rows for cameras whose images are late: half a second by default.
constexpr unsigned kStrandRows = 512;

}  // namespace

StrandSimulation::StrandSimulation(const StrandParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      model_{
          .length = parameters.length, .friction = parameters.friction, .wrap = parameters.wrap} {
  view_.keepState({.rows = kStrandRows});
}

void StrandSimulation::run() {
  const auto frames = registration_.frames();
  const auto left = left_.measured_cp(), right = right_.measured_cp();
  if (!frames || !left || !right || !left->valid || !right->valid) {
    state_.valid = false;
    return;
  }
  const Eigen::Vector3d leftTip = frames->left_base * left->pose.translation();
  const Eigen::Vector3d rightTip = frames->right_base * right->pose.translation();
  const suture::Time now = suture::now();
  if (!strand_) {
    if ((rightTip - leftTip).norm() < kLeastSpan) return;
    model_.tissue = frames->tissue;
    strand_.emplace(model_, leftTip, rightTip);
  } else {
    strand_->hold(Strand::Place::Left, leftTip);
    strand_->hold(Strand::Place::Right, rightTip);
    strand_->advance(std::min(secondsBetween(state_.stamp, now), kLongestStep));
  }
  state_ = {strand_->nodes(),
            strand_->leftLength(),
            strand_->leftTension(),
            strand_->rightTension(),
            now,
            true};
}

}  // namespace robots
