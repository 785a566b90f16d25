#pragma once
// This is what an operator works in, reduced to what the operator notices.

#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>

#include "arm/arm.suture.h"
#include "guidance/guidance.suture.h"
#include "vision/knot_vision.suture.h"

namespace robots::test {

/// Any thread may use members that are atomic. A Scene is a guide that lets everything pass, and a
/// camera that exposes a picture each cycle: the knot begins at the origin and moves by kScale
/// times the mean of what both masters move. The camera's frame is the scene's.
class Scene final : public suture::PeriodicTask, public KnotVision, public Guidance {
 public:
  static constexpr double kScale = 0.4;
  /// There are 15 pictures a second, as the synthetic endoscope has them.
  static constexpr suture::Duration kPeriod = std::chrono::microseconds(66'667);

  Scene() : PeriodicTask({.period = kPeriod}) {}

  void enable() override {}
  void disable() override {}
  GuidanceState guidance_state() const override { return GuidanceState::Guiding; }
  const GuidanceProgress& progress() const override { return progress_; }
  const ForbiddenMotion& forbidden_motion() const override { return forbidden_; }
  const KnotSighting& sighting() const override { return sighting_; }

  std::atomic<bool> covered = false;  ///< no camera sees the knot
  std::atomic<bool> frozen = false;   ///< the picture stays as it was

 private:
  void onStart() override { guidance_.emit().guidance_state(GuidanceState::Guiding); }
  void run() override {
    const auto left = left_.measured_cp(), right = right_.measured_cp();
    sighting_.valid = left && right && !covered;
    if (!sighting_.valid || frozen) return;
    sighting_.knot = kScale / 2 * (left->pose.translation() + right->pose.translation());
    sighting_.stamp = suture::now();
  }

  KnotSighting sighting_;
  GuidanceProgress progress_;
  ForbiddenMotion forbidden_;
  suture::Required<Arm> left_{*this, "Left"}, right_{*this, "Right"};
  suture::Provided<KnotVision> vision_{*this, "Vision", *this};
  suture::Provided<Guidance> guidance_{*this, "Guidance", *this};
};

}  // namespace robots::test
