#pragma once
// Where something is that was seen some moments ago.

#include <suture/base/time.h>

#include <Eigen/Core>

namespace robots {

/// A Kalman filter of constant velocity, each axis for itself: what it follows changes its velocity
/// by chance, and sightings have noise. Sightings have the stamp of their exposure, and it predicts
/// to any later time, so that their latency costs little. m, in one frame. Does not allocate;
/// belongs to one thread.
class TrackingFilter {
 public:
  /// `acceleration`: how fast the velocity changes, m/s^2.
  explicit TrackingFilter(double acceleration) : acceleration_(acceleration) {}

  /// It was at `place` at `stamp`, with a standard deviation of the noise for each axis, m. Stamps
  /// must ascend; another one is ignored.
  void seenAt(suture::Time stamp, const Eigen::Vector3d& place, const Eigen::Vector3d& noise);
  void forget() { known_ = false; }

  /// False before the first sighting.
  bool known() const { return known_; }
  /// The stamp of the last sighting.
  suture::Time seen() const { return seen_; }
  /// Where it is at `time`, and how fast it is, m/s; only if it is known.
  Eigen::Vector3d placeAt(suture::Time time) const;
  const Eigen::Vector3d& velocity() const { return velocity_; }

 private:
  void predictTo(suture::Time stamp);

  const double acceleration_;
  bool known_ = false;
  suture::Time seen_;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero();
  // The covariance of place and velocity, of each axis.
  Eigen::Array3d places_, both_, velocities_;
};

}  // namespace robots
