#include "vision/tracking_filter.h"

#include "timing/seconds.h"

namespace robots {
namespace {

// In m/s: instruments move about this fast, which is all that is known of a velocity before the
// second sighting.
constexpr double kSpeed = 0.1;

}  // namespace

void TrackingFilter::seenAt(suture::Time stamp, const Eigen::Vector3d& place,
                            const Eigen::Vector3d& noise) {
  const Eigen::Array3d variance = noise.array().square();
  if (!known_) {
    place_ = place;
    velocity_.setZero();
    places_ = variance;
    both_.setZero();
    velocities_.setConstant(kSpeed * kSpeed);
    seen_ = stamp;
    known_ = true;
    return;
  }
  if (stamp <= seen_) return;
  predictTo(stamp);
  const Eigen::Array3d gain = places_ / (places_ + variance);
  const Eigen::Array3d velocityGain = both_ / (places_ + variance);
  const Eigen::Array3d surprise = place - place_;
  place_.array() += gain * surprise;
  velocity_.array() += velocityGain * surprise;
  velocities_ -= velocityGain * both_;
  both_ *= 1 - gain;
  places_ *= 1 - gain;
}

/// Predicts the state at `stamp`, with an acceleration that is constant until then, and another one
/// after that.
void TrackingFilter::predictTo(suture::Time stamp) {
  const double t = secondsBetween(seen_, stamp);
  const double variance = acceleration_ * acceleration_;
  place_ += t * velocity_;
  places_ += t * (2 * both_ + t * velocities_) + t * t * t * t / 4 * variance;
  both_ += t * velocities_ + t * t * t / 2 * variance;
  velocities_ += t * t * variance;
  seen_ = stamp;
}

Eigen::Vector3d TrackingFilter::placeAt(suture::Time time) const {
  return place_ + secondsBetween(seen_, time) * velocity_;
}

}  // namespace robots
