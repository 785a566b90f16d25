#include "vision/knot_tracker.h"

#include "parameters/valid_age.h"
#include "vision/one_thread.h"

namespace robots {

KnotTracker::KnotTracker(const TrackerParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      tracks_{Track(*this, "Knot", parameters.acceleration),
              Track(*this, "LeftTip", parameters.acceleration),
              Track(*this, "RightTip", parameters.acceleration)} {
  requireAge("max_age", parameters.max_age);
  workInOneThread();
}

void KnotTracker::run() {
  look();
  for (Track& track : tracks_) track.publish(suture::now(), parameters_.max_age);
}

void KnotTracker::look() {
  const auto exposed = images_.exposed();
  if (exposed && *exposed == suture::Time{}) return see({});  // without a copy of megabytes
  if (exposed && *exposed == sighting_.stamp) return;
  if (!images_.images(pair_) || !isPairOfTheCameras()) return see({});
  sighting_.stamp = pair_.left.stamp;
  see(locate(cameras_, detect(pair_.left), detect(pair_.right)));
}

/// Passes each point to its track, or none, at the stamp of the sighting.
void KnotTracker::see(const MarkerPoints& points) {
  for (std::size_t i = 0; i < kMarkers; ++i) {
    tracks_[i].seenAt(sighting_.stamp, cameras_, points[i]);
  }
  const auto& [knot, left, right] = points;
  sighting_.valid = knot && left && right;
  if (!sighting_.valid) return;
  sighting_.knot = *knot;
  sighting_.left_tip = *left;
  sighting_.right_tip = *right;
}

/// Returns false for images of another size, or of two moments, because they would give a wrong
/// depth.
bool KnotTracker::isPairOfTheCameras() const {
  const auto fits = [this](const ImageFrame& image) {
    return image.valid && image.width == static_cast<std::uint32_t>(cameras_.width) &&
           image.height == static_cast<std::uint32_t>(cameras_.height);
  };
  return fits(pair_.left) && fits(pair_.right) && pair_.left.stamp == pair_.right.stamp;
}

}  // namespace robots
