#pragma once
// These are the simulated joint drives of a slave arm.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>

#include "coordinator/emergency_stop.suture.h"
#include "drives/drive_dynamics.suture.h"
#include "drives/drives.suture.h"
#include "drives/permit_watch.h"
#include "drives/simulated_drives.h"

namespace robots {

struct SUTURE_TYPE() PsmDrivesParameters {
  suture::Duration period = std::chrono::microseconds(667);
  /// The measured joints trail their goal by this time.
  SUTURE_FIELD(unit("s"), range(0.0001, 10)) double time_constant = 0.01;
  /// The rotating joints can be this fast.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 20)) double angular_rate = 4.0;
  /// The insertion can be this fast.
  SUTURE_FIELD(unit("m/s"), range(0.001, 2)) double insertion_rate = 0.4;
  /// The jaw can be this fast; by default as in the da Vinci Research Kit's teleoperation.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 50)) double jaw_rate = 12.566;
  /// The permit of the emergency stop may be this old: from 1 ms to 1 s. With 0, power needs none,
  /// as on a bench where nobody can be hurt; a stop that is connected still takes it.
  suture::Duration permit = std::chrono::milliseconds(30);
  /// Lag: the joints trail their goal. RigidBody: motors move bodies that have mass, and
  /// `time_constant` does not count.
  DriveDynamics dynamics = DriveDynamics::Lag;
  /// These have an effect only with RigidBody.
  RigidBodyOptions rigid_body{};
};

/// PsmDrives are the drives of a patient side manipulator. The instrument is in the patient from
/// the start, because the cannula is not simulated.
class SUTURE_COMPONENT() PsmDrives final : public suture::PeriodicTask, public SimulatedDrives<7> {
 public:
  explicit PsmDrives(const PsmDrivesParameters& parameters);

  void run() override;
  void onFault() override { brake(); }
  /// The drives have stopped meanwhile, so they get no power before the arm has been enabled again.
  void onRestart() override { permit(false); }

 private:
  SUTURE_REQUIRED(optional()) suture::Required<EmergencyStop> stop_{*this, "Stop"};
  PermitWatch permit_;
  suture::Provided<Drives> drives_{*this, "Drives", *this};
};

}  // namespace robots
