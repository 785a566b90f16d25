#pragma once
// This is the teleoperation task, in which one master drives one slave.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/gripper.suture.h"
#include "arm/jaw.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"
#include "pedals/operator_watch.h"
#include "registration/registration.suture.h"
#include "robot_types/side.h"
#include "teleop/arm_pair.h"
#include "teleop/follow_law.h"
#include "teleop/jaw_follower.h"
#include "teleop/master_alignment.h"
#include "teleop/master_release.h"
#include "teleop/preparation_limit.h"
#include "teleop/teleoperation.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() TeleopParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// The slave moves this many metres for each metre of the master.
  SUTURE_FIELD(range(0.01, 10)) double scale = 0.2;
  /// With data older than this following ends, and begins anew when they are fresh again.
  suture::Duration max_age = std::chrono::milliseconds(20);
  /// If it is true, the task prepares and follows without waiting for enable().
  bool enable_at_start = true;
  /// If it is true, the master is turned to the orientation of the slave before the slave follows.
  /// If not, the difference between them stays.
  bool align = true;
  /// A difference of at most this counts as none, and stays.
  SUTURE_FIELD(unit("rad"), range(0.001, 1)) double alignment_tolerance = 0.087;
  /// If it is true, the master's motors only carry it while it is the surgeon's to move, which is
  /// while the slave follows and while a pedal is pressed, and hold it otherwise. A master that
  /// gets goals from another client, such as a simulated surgeon, needs false: it moves by those.
  bool release_master = false;
  /// If the arms are not ready, or the master is not aligned, after this time, the teleoperation is
  /// disabled. With 0 it waits for ever.
  suture::Duration preparation_limit = std::chrono::seconds(60);
  /// If pedals or presence are older than this, they are not known, which ends following.
  suture::Duration operator_age = std::chrono::milliseconds(200);
  /// Following does not begin with a registration that was renewed longer ago than this. It goes on
  /// with the one with which it began.
  suture::Duration registration_age = std::chrono::milliseconds(250);
  /// The jaw turns this many radians for each radian of the gripper, from this angle with the
  /// gripper at 0: 60 degrees of the gripper are the 80 of the jaw.
  SUTURE_FIELD(range(0.01, 10)) double jaw_scale = 1.3333;
  SUTURE_FIELD(unit("rad"), range(-2, 2)) double jaw_offset = 0;
  /// The jaw follows this fast, and goes this fast to where the gripper is before that.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 50)) double jaw_rate = 12.566;
  SUTURE_FIELD(unit("rad/s"), range(0.01, 50)) double jaw_ghost_rate = 0.6283;
  /// When the jaw is this near to where the gripper is, it follows.
  SUTURE_FIELD(unit("rad"), range(0.001, 1)) double jaw_tolerance = 0.0349;
  /// Say which arms of the registration these are.
  Side master_side = Side::Left;
  Side slave_side = Side::Left;
};

/// Knows only contracts, and nothing of where arms and console are. It follows only while both arms
/// are enabled, homed and not busy, both arms' data are fresh, and the surgeon is there without a
/// foot on a pedal that takes the master. Each time that this becomes true, or the task itself
/// could not look for longer than max_age, it sends the slave its own set-point
/// until the slave carries that out, aligns the master and takes new anchors, so the slave never
/// jumps.
/// With a registration, directions are those that the surgeon sees. With a gripper and a jaw, the
/// jaw follows too (jaw_law.h).
class SUTURE_COMPONENT() Teleop final : public suture::PeriodicTask, public Teleoperation {
 public:
  /// Throws suture::SetupError for a scale or an age that is not above zero, an age above a minute,
  /// or a limit that is neither 0 nor from 1 ms to a day.
  explicit Teleop(const TeleopParameters& parameters);

  void enable() override;
  void disable() override;
  void set_scale(double scale) override;
  void lock_rotation(bool lock) override;
  void lock_translation(bool lock) override;
  TeleopState teleop_state() const override { return state_; }
  FollowAnchors anchors() const override { return anchors_; }
  TeleopSettings settings() const override { return settings_; }

  void run() override;
  /// A client that connects receives the first state too.
  void onStart() override;
  void onSuspend() override;
  void onResume() override;
  void onFault() override;

 private:
  void step(suture::Time now);
  bool knowsView();
  void rest(const ArmPoses& poses);
  bool isAligned(const ArmPoses& poses, suture::Time now);
  void offerGoal(TeleopState state, const ArmPoses& poses);
  void follow(const ArmPoses& poses);
  FollowSettings lawSettings() const;
  void announce(const PoseStamped& master, const Eigen::Isometry3d& slave);
  void settingsChanged();
  bool prepares() const;
  void giveUpIfLate();
  void giveUp(const char* why);
  void leave(TeleopState state);
  void enter(TeleopState state);

  const TeleopParameters parameters_;
  bool enableAtFirstCycle_;
  suture::Required<Arm> master_{*this, "Master"};
  suture::Required<Arm> slave_{*this, "Slave"};
  SUTURE_REQUIRED(optional()) suture::Required<Gripper> gripper_{*this, "Gripper"};
  SUTURE_REQUIRED(optional()) suture::Required<Jaw> jaw_{*this, "Jaw"};
  SUTURE_REQUIRED(optional()) suture::Required<FootPedals> pedals_{*this, "Pedals"};
  SUTURE_REQUIRED(optional()) suture::Required<OperatorPresence> presence_{*this, "Presence"};
  SUTURE_REQUIRED(optional()) suture::Required<Registration> registration_{*this, "Registration"};
  suture::Provided<Teleoperation> teleoperation_{*this, "Teleoperation", *this};
  suture::MessagePort messages_{*this};

  ArmPair arms_{master_, slave_};
  OperatorWatch operator_{pedals_, presence_, parameters_.operator_age};
  MasterAlignment alignment_{master_, arms_.master(), parameters_.alignment_tolerance};
  MasterRelease release_{master_, parameters_.release_master};
  JawFollower jawFollower_;
  CycleWatch cycles_;
  TeleopState state_ = TeleopState::Disabled;
  PreparationLimit preparation_{parameters_.preparation_limit};  // of arms, and of alignment
  bool isTurned_ = false;  // the master, against the slave, while that kept its orientation
  TeleopSettings settings_;
  Eigen::Matrix3d view_ = Eigen::Matrix3d::Identity();
  FollowAnchors anchors_;
  std::optional<FollowLaw> law_;
  std::optional<Eigen::Isometry3d> goal_;  // the last that the slave has got
  bool offers_ = false;                    // that is one to stay
  bool lawIsOld_ = false;                  // the settings have changed since the law was made
};

}  // namespace robots
