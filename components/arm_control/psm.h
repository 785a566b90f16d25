#pragma once
// This is the simulated slave arm.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>

#include "arm/arm.suture.h"
#include "arm/jaw.suture.h"
#include "arm_control/arm_controller.h"
#include "arm_control/crtk_arm.h"
#include "arm_control/drive_link.h"
#include "arm_control/jaw_controller.h"

namespace robots {

struct SUTURE_TYPE() PsmParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// The rotating joints move at this rate at most.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 20)) double angular_rate = 4.0;
  /// home() inserts the instrument this deep. Cartesian control needs 0.063 m: then the wrist is 47
  /// mm beyond the remote centre.
  SUTURE_FIELD(unit("m"), range(0, 0.24)) double home_insertion = 0.12;
  /// A rotating joint that trails its set-point by more than this faults the arm. One servo goal
  /// may lie 0.4 rad ahead of the set-point at these rates (servo_horizon), behind which the joints
  /// trail by rate x time constant already. Goals that run ahead of the joints by more fault the
  /// arm, though each is near the one before.
  SUTURE_FIELD(unit("rad"), range(0.001, 10)) double following_error = 0.8;
  /// The insertion moves at this rate at most.
  SUTURE_FIELD(unit("m/s"), range(0.001, 2)) double insertion_rate = 0.4;
  /// The same bound holds for the insertion.
  SUTURE_FIELD(unit("m"), range(0.0001, 1)) double insertion_following_error = 0.08;
  /// The rotating joints may speed up and slow down this fast in a move. Nothing is published of
  /// what the joints can do, so this is our own, as are the two below.
  SUTURE_FIELD(unit("rad/s2"), range(0.1, 1000)) double angular_acceleration = 40;
  /// This says the same of the insertion.
  SUTURE_FIELD(unit("m/s2"), range(0.01, 100)) double insertion_acceleration = 4;
  /// This says the same of the jaw.
  SUTURE_FIELD(unit("rad/s2"), range(0.1, 10000)) double jaw_acceleration = 200;
  /// The jaw moves at this rate at most; by default at that of the da Vinci Research Kit's
  /// teleoperation.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 50)) double jaw_rate = 12.566;
  /// A joint whose encoder measures a motion of more than this many times what the joint can do
  /// faults the arm.
  SUTURE_FIELD(range(1, 1000)) double jump_factor = 5;
  /// An effort that is above what the joint may take for longer than this faults the arm too.
  SUTURE_FIELD(unit("s"), range(0.001, 10)) double overload_time = 0.1;
  /// A servo goal may lie as far from the set-point as the joints can move in this time at their
  /// rate limits; one that lies farther is refused. By default this is as long as a stream may be
  /// silent: what the master does in 0.1 s is far below the rates of the slave. It must be so short
  /// that this is less than the following error of each joint.
  SUTURE_FIELD(unit("s"), range(0.001, 10)) double servo_horizon = 0.1;
};

/// A Psm is a patient side manipulator with large needle driver (kinematics/davinci.h). Its base
/// frame has its origin at the remote centre of motion. The jaw of the instrument is an interface
/// of its own, in the same cycle.
class SUTURE_COMPONENT() Psm final : public suture::PeriodicTask, public ArmController<6> {
 public:
  /// Throws suture::SetupError for a servo horizon in which a joint can move by its following
  /// error.
  explicit Psm(const PsmParameters& parameters);

  void run() override;
  void onConfigure() override { contract_.nameFrames(arm_.frames()); }
  void onRestart() override { startAnew(); }

 private:
  const suture::ConnectedClient* asking() const override { return caller(); }
  void onClient(const suture::ProvidedBase& interface, const suture::ConnectedClient& client,
                suture::ClientNews news) override;

  CrtkArm<6> contract_{*this};
  suture::Required<Drives> drives_{*this, "Drives"};
  DriveLink<6> link_{drives_, psmCoupling()};
  suture::Provided<Arm> arm_{*this, "Arm", contract_};
  JawController jaw_;
  suture::Provided<Jaw> jawPort_{*this, "Jaw", jaw_};
};

}  // namespace robots
