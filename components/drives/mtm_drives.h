#pragma once
// These are the simulated joint drives of a master arm.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <memory>

#include "coordinator/emergency_stop.suture.h"
#include "drives/drive_dynamics.suture.h"
#include "drives/drives.suture.h"
#include "drives/gripper_hand.suture.h"
#include "drives/held_gripper.h"
#include "drives/permit_watch.h"
#include "drives/simulated_drives.h"
#include "robot_types/side.h"

namespace robots {

struct SUTURE_TYPE() MtmDrivesParameters {
  /// Says which of a surgeon's two masters it is, because their joints have mirrored limits.
  Side side = Side::Left;
  suture::Duration period = std::chrono::microseconds(667);
  /// The measured joints trail their goal by this time: here, the hand that moves the master.
  SUTURE_FIELD(unit("s"), range(0.0001, 10)) double time_constant = 0.01;
  /// The joints can be this fast.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 20)) double angular_rate = 4.0;
  /// The permit of the emergency stop may be this old: from 1 ms to 1 s. With 0, power needs none,
  /// as on a bench where nobody can be hurt; a stop that is connected still takes it.
  suture::Duration permit = std::chrono::milliseconds(30);
  /// Lag: the joints trail their goal. RigidBody: motors move bodies that have mass, and
  /// `time_constant` does not count.
  DriveDynamics dynamics = DriveDynamics::Lag;
  /// These have an effect only with RigidBody.
  RigidBodyOptions rigid_body{};
};

/// MtmDrives are the drives of a master tool manipulator, and the surgeon's hand on its gripper.
class SUTURE_COMPONENT() MtmDrives final : public suture::PeriodicTask, public SimulatedDrives<8> {
 public:
  explicit MtmDrives(const MtmDrivesParameters& parameters);

  void run() override;
  void onFault() override { brake(); }
  /// The drives have stopped meanwhile, so they get no power before the arm has been enabled again.
  void onRestart() override { permit(false); }

 private:
  MtmDrives(const MtmDrivesParameters& parameters, std::shared_ptr<HeldGripper> gripper);

  std::shared_ptr<HeldGripper> gripper_;
  SUTURE_REQUIRED(optional()) suture::Required<EmergencyStop> stop_{*this, "Stop"};
  PermitWatch permit_;
  suture::Provided<Drives> drives_{*this, "Drives", *this};
  suture::Provided<GripperHand> hand_{*this, "Hand", *gripper_};
};

}  // namespace robots
