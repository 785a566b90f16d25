#include "vision/knot_tracker.h"

#include "vision/detector.h"

namespace robots {

KnotTracker::KnotTracker(const TrackerParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

void KnotTracker::run() {
  if (!images_.images(pair_) || !isPairOfTheCameras()) {
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

/// Of another size or of two moments, images would give a depth that is wrong.
bool KnotTracker::isPairOfTheCameras() const {
  const auto fits = [this](const ImageFrame& image) {
    return image.valid && image.width == static_cast<std::uint32_t>(cameras_.width) &&
           image.height == static_cast<std::uint32_t>(cameras_.height);
  };
  return fits(pair_.left) && fits(pair_.right) && pair_.left.stamp == pair_.right.stamp;
}

}  // namespace robots
