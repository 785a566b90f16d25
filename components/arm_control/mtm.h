#pragma once
// This is the simulated master arm.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>

#include "arm/arm.suture.h"
#include "arm/gripper.suture.h"
#include "arm_control/arm_controller.h"
#include "arm_control/crtk_arm.h"
#include "arm_control/drive_link.h"
#include "arm_control/gripper_reading.h"
#include "robot_types/side.h"

namespace robots {

struct SUTURE_TYPE() MtmParameters {
  Side side = Side::Left;
  suture::Duration period = std::chrono::milliseconds(1);
  SUTURE_FIELD(unit("rad/s"), range(0.01, 20)) double angular_rate = 4.0;
  /// The joints may speed up and slow down this fast in a move. Nothing is published of what they
  /// can do, so this is our own. The da Vinci Research Kit's moves keep to 0.785 rad/s2, the roll's
  /// to 6.28 (mtsIntuitiveResearchKitMTM.cpp: m_trajectory_j.a_max).
  SUTURE_FIELD(unit("rad/s2"), range(0.1, 1000)) double angular_acceleration = 40;
  /// A rotating joint that trails its set-point by more than this faults the arm. At these rates a
  /// servo goal may lie 0.4 rad ahead of the set-point (servo_horizon), and the joints trail the
  /// set-point by rate x time constant. Goals that run further ahead of the joints fault the arm,
  /// though each is near the one before.
  SUTURE_FIELD(unit("rad"), range(0.001, 10)) double following_error = 0.8;
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
  /// At this angle or less the gripper is closed.
  SUTURE_FIELD(unit("rad"), range(-0.2, 1.05)) double gripper_closed = 0;
  /// The gripper must be closed, or open, for this long before that is reported.
  SUTURE_FIELD(unit("s"), range(0, 1)) double gripper_debounce = 0.02;
};

/// An Mtm is a master tool manipulator (kinematics/davinci.h). No hand holds it: a surgeon
/// component drives it through servo_cp, and squeezes its gripper through its drives
/// (drives/gripper_hand.h).
class SUTURE_COMPONENT() Mtm final : public suture::PeriodicTask, public ArmController<7> {
 public:
  /// Throws suture::SetupError for a servo horizon in which a joint can move by its following
  /// error.
  explicit Mtm(const MtmParameters& parameters);

  void run() override;
  void onConfigure() override { contract_.nameFrames(arm_.frames()); }
  void onRestart() override { startAnew(); }

 private:
  const suture::ConnectedClient* asking() const override { return caller(); }
  void onClient(const suture::ProvidedBase& interface, const suture::ConnectedClient& client,
                suture::ClientNews news) override;

  CrtkArm<7> contract_{*this};
  suture::Required<Drives> drives_{*this, "Drives"};
  DriveLink<7> link_{drives_, withTool(mtmCoupling())};
  suture::Provided<Arm> arm_{*this, "Arm", contract_};
  GripperReading gripper_;
  suture::Provided<Gripper> gripperPort_{*this, "Gripper", gripper_};
};

}  // namespace robots
