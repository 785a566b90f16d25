#pragma once
// This is a scripted surgeon, which moves a simulated master.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "drives/gripper_hand.suture.h"
#include "surgeon/hand_path.h"
#include "teleop/teleoperation.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() SurgeonParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// The hand swings this far along its widest axis.
  SUTURE_FIELD(unit("m"), range(0, 0.2)) double amplitude = 0.1;
  /// The hand turns this far about its widest axis.
  SUTURE_FIELD(unit("rad"), range(0, 1)) double turn = 0.3;
  SUTURE_FIELD(unit("Hz"), range(0.001, 10)) double frequency = 0.3;
  /// The fingers open the gripper this far, as often as the hand swings.
  SUTURE_FIELD(unit("rad"), range(0, 1.047)) double opening = 0.5;
  /// It takes this long to reach the full swing.
  SUTURE_FIELD(unit("s"), range(0.1, 100)) double ramp = 1.0;
};

/// Drives the arm to which it is connected along a smooth path around where it first found it, from
/// the moment the arm is ready. Whenever the arm was not ready, or the task was delayed, it starts
/// anew from rest, where the arm is by then. Connected to a teleoperation it moves only while that
/// follows; connected to a hand, it opens and closes the gripper meanwhile.
class SUTURE_COMPONENT() Surgeon final : public suture::PeriodicTask {
 public:
  explicit Surgeon(const SurgeonParameters& parameters);

  void run() override;

 private:
  bool mayMove();
  void squeeze(double t);

  const HandPathShape shape_;
  const double opening_;
  suture::Required<Arm> master_{*this, "Master"};
  SUTURE_REQUIRED(optional())
  suture::Required<Teleoperation> teleoperation_{*this, "Teleoperation"};
  SUTURE_REQUIRED(optional()) suture::Required<GripperHand> hand_{*this, "Hand"};
  ArmWatch watch_{master_};
  CycleWatch cycles_;
  std::optional<Eigen::Isometry3d> centre_;  // of the path, which would walk out of reach otherwise
  std::optional<HandPath> path_;
  suture::Time setOut_;
  double opened_ = 0;     // rad, the gripper by the fingers
  bool follows_ = false;  // the slave
};

}  // namespace robots
