#pragma once
// This computes where something is that was seen some moments ago.

#include <suture/base/time.h>

#include <Eigen/Core>

namespace robots {

/// Belongs to one thread; never allocates. A TrackingFilter is a Kalman filter of constant velocity
/// for each axis: what it follows changes its velocity by chance, and sightings have noise.
/// Sightings have the stamp of their exposure, and it predicts to any later time, so that their
/// latency costs little accuracy. Lengths are in m, in one frame.
class TrackingFilter {
 public:
  /// `acceleration` is how fast the velocity changes, in m/s^2.
  explicit TrackingFilter(double acceleration) : acceleration_(acceleration) {}

  /// Says that it was at `place` at `stamp`, with a standard deviation of the noise for each axis,
  /// in m. Stamps must ascend; any other is ignored.
  void seenAt(suture::Time stamp, const Eigen::Vector3d& place, const Eigen::Vector3d& noise);
  void forget() { known_ = false; }

  /// Returns false before the first sighting.
  bool known() const { return known_; }
  /// Returns the stamp of the last sighting.
  suture::Time seen() const { return seen_; }
  /// These return where it is at `time`, and how fast it is in m/s. Call them only if it is known.
  Eigen::Vector3d placeAt(suture::Time time) const;
  const Eigen::Vector3d& velocity() const { return velocity_; }

 private:
  void predictTo(suture::Time stamp);

  const double acceleration_;
  bool known_ = false;
  suture::Time seen_;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero();
  // This is the covariance of place and velocity, for each axis.
  Eigen::Array3d places_, both_, velocities_;
};

}  // namespace robots
