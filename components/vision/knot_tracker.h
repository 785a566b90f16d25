#pragma once
// The task that finds the knot and both tips in a stereo endoscope's images.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/periodic_task.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <chrono>

#include "vision/camera_pair.h"
#include "vision/knot_vision.suture.h"
#include "vision/stereo_images.suture.h"

namespace robots {

struct SUTURE_TYPE() TrackerParameters {
  /// As often it looks for new images.
  suture::Duration period = std::chrono::milliseconds(20);
};

/// Knows the images, and nothing else of the scene.
class SUTURE_COMPONENT() KnotTracker final : public suture::PeriodicTask, public KnotVision {
 public:
  explicit KnotTracker(const TrackerParameters& parameters);

  const KnotSighting& sighting() const override { return sighting_; }

  void run() override;

 private:
  bool isPairOfTheCameras() const;

  const CameraPair cameras_;
  suture::Required<StereoImages> images_{*this, "Images"};
  suture::Provided<KnotVision> vision_{*this, "Vision", *this};
  StereoPair pair_;  // keeps its memory
  KnotSighting sighting_;
};

}  // namespace robots
