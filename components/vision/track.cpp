#include "vision/track.h"

#include "vision/detector.h"

namespace robots {

void Track::seenAt(suture::Time stamp, const CameraPair& cameras,
                   const std::optional<Eigen::Vector3d>& place) {
  if (!place) return filter_.forget();
  filter_.seenAt(stamp, *place, cameras.deviation(*place, kDisparityNoise));
}

void Track::publish(suture::Time now, suture::Duration age) {
  pose_.valid = twist_.valid = filter_.known() && now - filter_.seen() <= age;
  if (!pose_.valid) return;
  pose_.pose.translation() = filter_.placeAt(now);
  twist_.linear = filter_.velocity();
  pose_.stamp = twist_.stamp = now;
}

}  // namespace robots
