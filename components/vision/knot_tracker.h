#pragma once
// This is the task that finds the knot and both tips in a stereo endoscope's images.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <array>
#include <chrono>

#include "vision/camera_pair.h"
#include "vision/detector.h"
#include "vision/knot_vision.suture.h"
#include "vision/stereo_images.suture.h"
#include "vision/track.h"

namespace robots {

struct SUTURE_TYPE() TrackerParameters {
  /// It looks for new images, and publishes poses, once in this period.
  suture::Duration period = std::chrono::milliseconds(20);
  /// A pose is not valid if it was seen longer ago than this: some three images.
  suture::Duration max_age = std::chrono::milliseconds(250);
  /// The velocity of what it follows changes this fast. This is our own number: that of a careful
  /// hand.
  SUTURE_FIELD(unit("m/s2"), range(0.001, 100)) double acceleration = 0.1;
};

/// Knows only the images of the scene. Its sighting is what the last pair showed, as it was then;
/// the poses are filtered and of the present. It runs under the default scheduler, in one thread,
/// and OpenCV allocates.
class SUTURE_COMPONENT() KnotTracker final : public suture::PeriodicTask, public KnotVision {
 public:
  /// Throws suture::SetupError for an age that is not above zero, or is above a minute.
  explicit KnotTracker(const TrackerParameters& parameters);

  const KnotSighting& sighting() const override { return sighting_; }

  void run() override;

 private:
  void look();
  void see(const MarkerPoints& points);
  bool isPairOfTheCameras() const;

  const TrackerParameters parameters_;
  const CameraPair cameras_;
  suture::Required<StereoImages> images_{*this, "Images"};
  suture::Provided<KnotVision> vision_{*this, "Vision", *this};
  std::array<Track, kMarkers> tracks_;  // by the markers' numbers
  StereoPair pair_;                     // keeps its memory
  KnotSighting sighting_;
};

}  // namespace robots
