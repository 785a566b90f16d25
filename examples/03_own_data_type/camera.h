#pragma once
// This is the provider: a simulated camera.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include "03_own_data_type/tracker.suture.h"

namespace tracking {

/// The deployment file gives these as JSON, including the whole observation.
struct SUTURE_TYPE() CameraParameters {
  /// The camera sees this first.
  Observation first;
  /// The instrument turns this fast about its own z axis.
  SUTURE_FIELD(unit("rad/s"), range(-10, 10)) double turn_rate = 0.5;
};

class SUTURE_COMPONENT() Camera final : public suture::PeriodicTask, public Tracker {
 public:
  explicit Camera(const CameraParameters& parameters);

  const Observation& observation() const override { return seen_; }
  void run() override;

 private:
  const double turnPerCycle_;  // rad
  Observation seen_;
  suture::Provided<Tracker> tracker_{*this, "Tracker", *this};
};

}  // namespace tracking
