#pragma once
// The master that a person's hand holds.

#include <suture/base/time.h>
#include <suture/component/required.h>

#include <Eigen/Geometry>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "drives/gripper_hand.suture.h"
#include "person/hand_input.h"
#include "teleop/teleoperation.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

/// Makes goals of a person's velocities, beginning from the arm's set-point each time. It moves the
/// arm only while that is ready and its set-point is fresh, and, connected to a teleoperation,
/// while that follows or its clutch is pressed: whoever moves a master that is being aligned fights
/// with it. When it has not been so, or the task was held up, the person has to let go first, for a
/// stick that is held meanwhile was not meant for what is there then.
///
/// A member of the component that owns the three interfaces, declared after them; belongs to the
/// same thread. Never allocates.
class HeldMaster {
 public:
  /// `opening`: rad, of the gripper when it is open.
  HeldMaster(suture::Required<Arm>& master, suture::Required<Teleoperation>& teleoperation,
             suture::Required<GripperHand>& hand, double opening);
  HeldMaster(const HeldMaster&) = delete;
  HeldMaster& operator=(const HeldMaster&) = delete;

  /// Once a cycle.
  void move(const HandInput& input);

 private:
  bool mayMove();
  void letGo();
  void lead(const HandInput& input, const Eigen::Isometry3d& setpoint, double dt);

  suture::Required<Arm>& master_;
  suture::Required<Teleoperation>& teleoperation_;
  suture::Required<GripperHand>& hand_;
  const double opening_;
  ArmWatch watch_;
  CycleWatch cycles_;
  suture::Time last_;                      // cycle
  std::optional<Eigen::Isometry3d> goal_;  // while it moves
  bool mayBeMoved_ = false;                // by the teleoperation
  bool hasRested_ = false;                 // since it may move
};

}  // namespace robots
