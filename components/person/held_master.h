#pragma once
// This is the master that a person's hand holds.

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

/// Belongs to the thread of the component that owns the three interfaces, which has it as a member
/// declared after them. Never allocates.
///
/// Makes goals of a person's velocities, beginning from the arm's set-point each time. It moves the
/// arm only while that is ready and its set-point is fresh, and, if it is connected to a
/// teleoperation, only while that follows or its clutch is pressed, because moving a master that is
/// being aligned would work against it. After an interruption of these, or a delay of the task, the
/// person has to let go first, because a stick that was held meanwhile was not meant for the new
/// situation.
class HeldMaster {
 public:
  /// `opening` is the angle of the gripper when it is open, in rad.
  HeldMaster(suture::Required<Arm>& master, suture::Required<Teleoperation>& teleoperation,
             suture::Required<GripperHand>& hand, double opening);
  HeldMaster(const HeldMaster&) = delete;
  HeldMaster& operator=(const HeldMaster&) = delete;

  /// Call this once a cycle.
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
  bool mayBeMoved_ = false;                // the teleoperation permits it
  bool hasRested_ = false;                 // since it may move
};

}  // namespace robots
