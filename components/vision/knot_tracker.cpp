#include "vision/knot_tracker.h"

#include "vision/detector.h"

namespace robots {

KnotTracker::KnotTracker(const TrackerParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

void KnotTracker::run() {
  if (!images_.images(pair_) || !pair_.left.valid || !pair_.right.valid) {
    sighting_.valid = false;
    return;
  }
  if (pair_.left.stamp == sighting_.stamp) return;
  const MarkerPoints points = locate(cameras_, detect(pair_.left), detect(pair_.right));
  const auto& knot = points[static_cast<std::size_t>(Marker::Knot)];
  const auto& left = points[static_cast<std::size_t>(Marker::LeftTip)];
  const auto& right = points[static_cast<std::size_t>(Marker::RightTip)];
  sighting_.stamp = pair_.left.stamp;
  sighting_.valid = knot && left && right;
  if (!sighting_.valid) return;
  sighting_.knot = *knot;
  sighting_.left_tip = *left;
  sighting_.right_tip = *right;
}

}  // namespace robots
