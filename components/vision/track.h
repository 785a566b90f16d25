#pragma once
// This is one of the things that a tracker follows.

#include <suture/component/provided.h>

#include <optional>

#include "vision/camera_pair.h"
#include "vision/tracked_object.suture.h"
#include "vision/tracking_filter.h"

namespace robots {

/// Follows a marker from image to image, and provides its interface of the tracker.
class Track final : public TrackedObject {
 public:
  Track(suture::Component& tracker, const char* name, double acceleration)
      : filter_(acceleration), provided_(tracker, name, *this) {}

  /// Says where the last pair showed it, in the frame of the left camera, in m; none if it did not.
  void seenAt(suture::Time stamp, const CameraPair& cameras,
              const std::optional<Eigen::Vector3d>& place);
  /// Call this once a cycle. Computes what the contract answers now. A marker that was seen longer
  /// ago than `age` is not valid.
  void publish(suture::Time now, suture::Duration age);

  const PoseStamped& measured_cp() const override { return pose_; }
  const Twist& measured_cv() const override { return twist_; }

 private:
  TrackingFilter filter_;
  suture::Provided<TrackedObject> provided_;
  PoseStamped pose_;
  Twist twist_;
};

}  // namespace robots
