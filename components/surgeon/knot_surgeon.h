#pragma once
// This is a scripted surgeon who carries a knot with both hands.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <Eigen/Geometry>
#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "guidance/guidance.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() KnotSurgeonParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// Both hands go by this from where they first are, in the masters' base frames.
  SUTURE_FIELD(unit("m")) Eigen::Vector3d carry{0, 0, -0.04};
  /// That takes this long, and after each interruption what is left of it.
  SUTURE_FIELD(unit("s"), range(0.1, 100)) double duration = 4;
  /// The hands sway this far to the side meanwhile and afterwards, and this often.
  SUTURE_FIELD(unit("m"), range(0, 0.05)) double sway = 0.005;
  SUTURE_FIELD(unit("Hz"), range(0, 10)) double sway_frequency = 0.5;
};

/// Moves both masters in one script, without looking, from the moment the guide says that it
/// guides; holds them while it does not.
class SUTURE_COMPONENT() KnotSurgeon final : public suture::PeriodicTask {
 public:
  explicit KnotSurgeon(const KnotSurgeonParameters& parameters);

  void run() override;

 private:
  /// Returns how far the hands are from where they started, `t` seconds later.
  Eigen::Vector3d moved(double t) const;
  double doneAfter(double t) const;
  /// Stops the hands; the way that they have gone so far is not repeated.
  void interrupt();

  const KnotSurgeonParameters parameters_;
  suture::Required<Arm> left_{*this, "Left"};
  suture::Required<Arm> right_{*this, "Right"};
  suture::Required<Guidance> guidance_{*this, "Guidance"};
  ArmWatch leftWatch_{left_}, rightWatch_{right_};
  CycleWatch cycles_;
  bool guided_ = false;
  double rest_ = 1;  // share of the way, and of the time that it takes, which is left
  struct Start {
    Eigen::Isometry3d left, right;
    suture::Time at;
    suture::Time moved;  // for the last time
  };
  std::optional<Start> start_;
};

}  // namespace robots
