// Written by suturec from arm/crtk_arm.h. Do not edit.
#pragma once

#include <suture/base/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "arm/crtk_arm.h"
#include "robot_types/cartesian.suture.h"
#include "robot_types/joint_commands.suture.h"
#include "robot_types/joints.suture.h"
#include "robot_types/messages.suture.h"
#include "robot_types/operating_state.suture.h"
#include "robot_types/pose.suture.h"
#include "suture/standard/messages.suture.h"

namespace robots {

// --- CrtkArm: the arguments of its commands ---

struct CrtkArmStateCommandArguments {
  suture::BoundedText<15> name;
};

bool store(const std::string& name, CrtkArmStateCommandArguments& slot);

struct CrtkArmSetBaseFrameArguments {
  PoseStampedSlot frame;
};

bool store(const PoseStamped& frame, CrtkArmSetBaseFrameArguments& slot);
void shiftStamps(CrtkArmSetBaseFrameArguments& slot, suture::Duration shift);

struct CrtkArmUseGravityCompensationArguments {
  std::uint8_t use;
};

bool store(const bool& use, CrtkArmUseGravityCompensationArguments& slot);

struct CrtkArmServoJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, CrtkArmServoJpArguments& slot);
void shiftStamps(CrtkArmServoJpArguments& slot, suture::Duration shift);

struct CrtkArmServoJrArguments {
  JointGoalSlot step;
};

bool store(const JointGoal& step, CrtkArmServoJrArguments& slot);
void shiftStamps(CrtkArmServoJrArguments& slot, suture::Duration shift);

struct CrtkArmServoJvArguments {
  JointVelocityGoalSlot goal;
};

bool store(const JointVelocityGoal& goal, CrtkArmServoJvArguments& slot);
void shiftStamps(CrtkArmServoJvArguments& slot, suture::Duration shift);

struct CrtkArmServoJfArguments {
  JointEffortGoalSlot goal;
};

bool store(const JointEffortGoal& goal, CrtkArmServoJfArguments& slot);
void shiftStamps(CrtkArmServoJfArguments& slot, suture::Duration shift);

struct CrtkArmServoCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, CrtkArmServoCpArguments& slot);
void shiftStamps(CrtkArmServoCpArguments& slot, suture::Duration shift);

struct CrtkArmServoCrArguments {
  PoseStampedSlot step;
};

bool store(const PoseStamped& step, CrtkArmServoCrArguments& slot);
void shiftStamps(CrtkArmServoCrArguments& slot, suture::Duration shift);

struct CrtkArmServoCvArguments {
  TwistGoalSlot goal;
};

bool store(const TwistGoal& goal, CrtkArmServoCvArguments& slot);
void shiftStamps(CrtkArmServoCvArguments& slot, suture::Duration shift);

struct CrtkArmBodyServoCfArguments {
  WrenchGoalSlot goal;
};

bool store(const WrenchGoal& goal, CrtkArmBodyServoCfArguments& slot);
void shiftStamps(CrtkArmBodyServoCfArguments& slot, suture::Duration shift);

struct CrtkArmSpatialServoCfArguments {
  WrenchGoalSlot goal;
};

bool store(const WrenchGoal& goal, CrtkArmSpatialServoCfArguments& slot);
void shiftStamps(CrtkArmSpatialServoCfArguments& slot, suture::Duration shift);

struct CrtkArmMoveJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, CrtkArmMoveJpArguments& slot);
void shiftStamps(CrtkArmMoveJpArguments& slot, suture::Duration shift);

struct CrtkArmMoveJrArguments {
  JointGoalSlot step;
};

bool store(const JointGoal& step, CrtkArmMoveJrArguments& slot);
void shiftStamps(CrtkArmMoveJrArguments& slot, suture::Duration shift);

struct CrtkArmMoveCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, CrtkArmMoveCpArguments& slot);
void shiftStamps(CrtkArmMoveCpArguments& slot, suture::Duration shift);

struct CrtkArmMoveCrArguments {
  PoseStampedSlot step;
};

bool store(const PoseStamped& step, CrtkArmMoveCrArguments& slot);
void shiftStamps(CrtkArmMoveCrArguments& slot, suture::Duration shift);

struct CrtkArmTrajectoryJSetRatioArguments {
  double ratio;
};

bool store(const double& ratio, CrtkArmTrajectoryJSetRatioArguments& slot);

struct CrtkArmTrajectoryJSetRatioVArguments {
  double ratio;
};

bool store(const double& ratio, CrtkArmTrajectoryJSetRatioVArguments& slot);

struct CrtkArmTrajectoryJSetRatioAArguments {
  double ratio;
};

bool store(const double& ratio, CrtkArmTrajectoryJSetRatioAArguments& slot);

struct CrtkArmForwardKinematicsArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, CrtkArmForwardKinematicsArguments& slot);
void shiftStamps(CrtkArmForwardKinematicsArguments& slot, suture::Duration shift);

struct CrtkArmInverseKinematicsArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, CrtkArmInverseKinematicsArguments& slot);
void shiftStamps(CrtkArmInverseKinematicsArguments& slot, suture::Duration shift);

struct CrtkArmQueryCpArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, CrtkArmQueryCpArguments& slot);
void shiftStamps(CrtkArmQueryCpArguments& slot, suture::Duration shift);

struct CrtkArmLocalQueryCpArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, CrtkArmLocalQueryCpArguments& slot);
void shiftStamps(CrtkArmLocalQueryCpArguments& slot, suture::Duration shift);

/// The numbers of CrtkArm's commands in every table and record.
enum class CrtkArmCommand : std::uint16_t {
  configuration_js,
  operating_state,
  period_statistics,
  enable,
  disable,
  pause,
  resume,
  home,
  unhome,
  state_command,
  measured_js,
  setpoint_js,
  goal_js,
  measured_cp,
  setpoint_cp,
  goal_cp,
  local_measured_cp,
  local_setpoint_cp,
  measured_cv,
  setpoint_cv,
  body_measured_cf,
  spatial_measured_cf,
  measured_cs,
  body_jacobian,
  spatial_jacobian,
  base_frame,
  set_base_frame,
  hold,
  free,
  use_gravity_compensation,
  servo_jp,
  servo_jr,
  servo_jv,
  servo_jf,
  servo_cp,
  servo_cr,
  servo_cv,
  body_servo_cf,
  spatial_servo_cf,
  move_jp,
  move_jr,
  move_cp,
  move_cr,
  trajectory_j_set_ratio,
  trajectory_j_set_ratio_v,
  trajectory_j_set_ratio_a,
  trajectory_j_ratio,
  trajectory_j_ratio_v,
  trajectory_j_ratio_a,
  forward_kinematics,
  inverse_kinematics,
  query_cp,
  local_query_cp,
};

/// The numbers of CrtkArm's own events.
enum class CrtkArmEvent : std::uint16_t {
  operating_state = 3,
  desired_state,
  goal_reached,
  gravity_compensation,
  trajectory_j_ratio,
  trajectory_j_ratio_v,
  trajectory_j_ratio_a,
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::CrtkArm>();

/// What a client of robots::CrtkArm calls.
template <>
class Required<robots::CrtkArm> : public Required<suture::Messages> {
  using Contract = robots::CrtkArm;
  using Id = robots::CrtkArmCommand;
  using EventId = robots::CrtkArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// What the joints are and may do.
  ReadCommand<&Contract::configuration_js, robots::JointConfigurationSlot> configuration_js{
      *this, static_cast<std::uint16_t>(Id::configuration_js)};
  ReadCommand<&Contract::operating_state, robots::OperatingStateSlot> operating_state{
      *this, static_cast<std::uint16_t>(Id::operating_state)};
  /// How regularly the arm's task ran in the last second.
  ReadCommand<&Contract::period_statistics, robots::IntervalStatisticsSlot> period_statistics{
      *this, static_cast<std::uint16_t>(Id::period_statistics)};
  /// Gives the drives power; the arm holds its position.
  Command<&Contract::enable, NoSlot> enable{*this, static_cast<std::uint16_t>(Id::enable)};
  /// Stops at once, without power, and ignores motion until enabled again.
  Command<&Contract::disable, NoSlot> disable{*this, static_cast<std::uint16_t>(Id::disable)};
  /// Stops where the joints are and ignores motion until resume().
  Command<&Contract::pause, NoSlot> pause{*this, static_cast<std::uint16_t>(Id::pause)};
  Command<&Contract::resume, NoSlot> resume{*this, static_cast<std::uint16_t>(Id::resume)};
  /// Moves to the home position; needs an enabled arm. Ends with goal_reached.
  Command<&Contract::home, NoSlot> home{*this, static_cast<std::uint16_t>(Id::home)};
  /// Forgets that it is homed.
  Command<&Contract::unhome, NoSlot> unhome{*this, static_cast<std::uint16_t>(Id::unhome)};
  /// One of the six above, by name; anything else is an `error`.
  Command<&Contract::state_command, robots::CrtkArmStateCommandArguments> state_command{
      *this, static_cast<std::uint16_t>(Id::state_command)};
  ReadCommand<&Contract::measured_js, robots::JointStateSlot> measured_js{
      *this, static_cast<std::uint16_t>(Id::measured_js)};
  ReadCommand<&Contract::setpoint_js, robots::JointStateSlot> setpoint_js{
      *this, static_cast<std::uint16_t>(Id::setpoint_js)};
  /// Where the move under way ends; without one, the set-point.
  ReadCommand<&Contract::goal_js, robots::JointStateSlot> goal_js{
      *this, static_cast<std::uint16_t>(Id::goal_js)};
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{
      *this, static_cast<std::uint16_t>(Id::measured_cp)};
  ReadCommand<&Contract::setpoint_cp, robots::PoseStampedSlot> setpoint_cp{
      *this, static_cast<std::uint16_t>(Id::setpoint_cp)};
  /// Where the move under way ends; without one, the set-point.
  ReadCommand<&Contract::goal_cp, robots::PoseStampedSlot> goal_cp{
      *this, static_cast<std::uint16_t>(Id::goal_cp)};
  ReadCommand<&Contract::local_measured_cp, robots::PoseStampedSlot> local_measured_cp{
      *this, static_cast<std::uint16_t>(Id::local_measured_cp)};
  ReadCommand<&Contract::local_setpoint_cp, robots::PoseStampedSlot> local_setpoint_cp{
      *this, static_cast<std::uint16_t>(Id::local_setpoint_cp)};
  /// Of the tip, in the directions of the reference frame.
  ReadCommand<&Contract::measured_cv, robots::TwistSlot> measured_cv{
      *this, static_cast<std::uint16_t>(Id::measured_cv)};
  ReadCommand<&Contract::setpoint_cv, robots::TwistSlot> setpoint_cv{
      *this, static_cast<std::uint16_t>(Id::setpoint_cv)};
  /// Force on the tip in its own directions.
  ReadCommand<&Contract::body_measured_cf, robots::WrenchSlot> body_measured_cf{
      *this, static_cast<std::uint16_t>(Id::body_measured_cf)};
  /// Force on the tip in the directions of the arm's base frame.
  ReadCommand<&Contract::spatial_measured_cf, robots::WrenchSlot> spatial_measured_cf{
      *this, static_cast<std::uint16_t>(Id::spatial_measured_cf)};
  /// Pose, velocity and force of one cycle, in the reference frame.
  ReadCommand<&Contract::measured_cs, robots::CartesianStateSlot> measured_cs{
      *this, static_cast<std::uint16_t>(Id::measured_cs)};
  /// From joint velocities to those of the tip, in its own directions.
  ReadCommand<&Contract::body_jacobian, robots::JacobianSlot> body_jacobian{
      *this, static_cast<std::uint16_t>(Id::body_jacobian)};
  /// The same in the directions of the arm's base frame.
  ReadCommand<&Contract::spatial_jacobian, robots::JacobianSlot> spatial_jacobian{
      *this, static_cast<std::uint16_t>(Id::spatial_jacobian)};
  ReadCommand<&Contract::base_frame, robots::PoseStampedSlot> base_frame{
      *this, static_cast<std::uint16_t>(Id::base_frame)};
  Command<&Contract::set_base_frame, robots::CrtkArmSetBaseFrameArguments> set_base_frame{
      *this, static_cast<std::uint16_t>(Id::set_base_frame)};
  /// Drops what is under way; the set-point stays where it is.
  Command<&Contract::hold, NoSlot> hold{*this, static_cast<std::uint16_t>(Id::hold)};
  /// Lets go: the set-point follows the joints until another command.
  Command<&Contract::free, NoSlot> free{*this, static_cast<std::uint16_t>(Id::free)};
  Command<&Contract::use_gravity_compensation,
          robots::CrtkArmUseGravityCompensationArguments> use_gravity_compensation{
      *this, static_cast<std::uint16_t>(Id::use_gravity_compensation)};
  Command<&Contract::servo_jp, robots::CrtkArmServoJpArguments> servo_jp{
      *this, static_cast<std::uint16_t>(Id::servo_jp)};
  Command<&Contract::servo_jr, robots::CrtkArmServoJrArguments> servo_jr{
      *this, static_cast<std::uint16_t>(Id::servo_jr)};
  Command<&Contract::servo_jv, robots::CrtkArmServoJvArguments> servo_jv{
      *this, static_cast<std::uint16_t>(Id::servo_jv)};
  Command<&Contract::servo_jf, robots::CrtkArmServoJfArguments> servo_jf{
      *this, static_cast<std::uint16_t>(Id::servo_jf)};
  Command<&Contract::servo_cp, robots::CrtkArmServoCpArguments> servo_cp{
      *this, static_cast<std::uint16_t>(Id::servo_cp)};
  /// The step's translation in the reference frame; its rotation turns the tip about itself.
  Command<&Contract::servo_cr, robots::CrtkArmServoCrArguments> servo_cr{
      *this, static_cast<std::uint16_t>(Id::servo_cr)};
  Command<&Contract::servo_cv, robots::CrtkArmServoCvArguments> servo_cv{
      *this, static_cast<std::uint16_t>(Id::servo_cv)};
  /// In the tip's own directions.
  Command<&Contract::body_servo_cf, robots::CrtkArmBodyServoCfArguments> body_servo_cf{
      *this, static_cast<std::uint16_t>(Id::body_servo_cf)};
  /// In the directions of the arm's base frame.
  Command<&Contract::spatial_servo_cf, robots::CrtkArmSpatialServoCfArguments> spatial_servo_cf{
      *this, static_cast<std::uint16_t>(Id::spatial_servo_cf)};
  /// Moves plan and execute a smooth motion from the set-point. Each ends with goal_reached.
  Command<&Contract::move_jp, robots::CrtkArmMoveJpArguments> move_jp{
      *this, static_cast<std::uint16_t>(Id::move_jp)};
  Command<&Contract::move_jr, robots::CrtkArmMoveJrArguments> move_jr{
      *this, static_cast<std::uint16_t>(Id::move_jr)};
  Command<&Contract::move_cp, robots::CrtkArmMoveCpArguments> move_cp{
      *this, static_cast<std::uint16_t>(Id::move_cp)};
  Command<&Contract::move_cr, robots::CrtkArmMoveCrArguments> move_cr{
      *this, static_cast<std::uint16_t>(Id::move_cr)};
  /// How fast moves are, of what the joints can do: velocity and acceleration together.
  Command<&Contract::trajectory_j_set_ratio,
          robots::CrtkArmTrajectoryJSetRatioArguments> trajectory_j_set_ratio{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_set_ratio)};
  Command<&Contract::trajectory_j_set_ratio_v,
          robots::CrtkArmTrajectoryJSetRatioVArguments> trajectory_j_set_ratio_v{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_set_ratio_v)};
  Command<&Contract::trajectory_j_set_ratio_a,
          robots::CrtkArmTrajectoryJSetRatioAArguments> trajectory_j_set_ratio_a{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_set_ratio_a)};
  /// The smaller of the two below.
  ReadCommand<&Contract::trajectory_j_ratio, double> trajectory_j_ratio{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_ratio)};
  ReadCommand<&Contract::trajectory_j_ratio_v, double> trajectory_j_ratio_v{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_ratio_v)};
  ReadCommand<&Contract::trajectory_j_ratio_a, double> trajectory_j_ratio_a{
      *this, static_cast<std::uint16_t>(Id::trajectory_j_ratio_a)};
  /// The tool tip for a joint vector; not valid if it has the wrong length.
  QualifiedReadCommand<&Contract::forward_kinematics, robots::CrtkArmForwardKinematicsArguments,
                       robots::PoseStampedSlot> forward_kinematics{
      *this, static_cast<std::uint16_t>(Id::forward_kinematics)};
  /// A joint vector for a tool tip, searched from the present set-point.
  QualifiedReadCommand<&Contract::inverse_kinematics, robots::CrtkArmInverseKinematicsArguments,
                       robots::JointSolutionSlot> inverse_kinematics{
      *this, static_cast<std::uint16_t>(Id::inverse_kinematics)};
  /// The pose of the link behind as many joints as the vector has, at most all: none, the base.
  QualifiedReadCommand<&Contract::query_cp, robots::CrtkArmQueryCpArguments,
                       robots::PoseStampedSlot> query_cp{
      *this, static_cast<std::uint16_t>(Id::query_cp)};
  /// The same in the arm's base frame.
  QualifiedReadCommand<&Contract::local_query_cp, robots::CrtkArmLocalQueryCpArguments,
                       robots::PoseStampedSlot> local_query_cp{
      *this, static_cast<std::uint16_t>(Id::local_query_cp)};

  /// The events of robots::CrtkArm, to subscribe to.
  struct Events : Required<suture::Messages>::Events {
    explicit Events(RequiredBase& required)
        : Required<suture::Messages>::Events(required),
          operating_state{required, static_cast<std::uint16_t>(EventId::operating_state)},
          desired_state{required, static_cast<std::uint16_t>(EventId::desired_state)},
          goal_reached{required, static_cast<std::uint16_t>(EventId::goal_reached)},
          gravity_compensation{required, static_cast<std::uint16_t>(EventId::gravity_compensation)},
          trajectory_j_ratio{required, static_cast<std::uint16_t>(EventId::trajectory_j_ratio)},
          trajectory_j_ratio_v{required, static_cast<std::uint16_t>(EventId::trajectory_j_ratio_v)},
          trajectory_j_ratio_a{required, static_cast<std::uint16_t>(EventId::trajectory_j_ratio_a)} {}

    /// Each change of the operating state, and the last one to whoever connects.
    Subscription<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// The state that a command asked for.
    Subscription<std::uint8_t, robots::ArmState> desired_state;
    /// A move ended: true at its goal, false when something else replaced it.
    Subscription<std::uint8_t, bool> goal_reached;
    Subscription<std::uint8_t, bool> gravity_compensation;
    Subscription<double, double> trajectory_j_ratio;
    Subscription<double, double> trajectory_j_ratio_v;
    Subscription<double, double> trajectory_j_ratio_a;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<suture::Messages>(owner, name, info) {}

 private:
  Events events_{*this};
};

/// What serves robots::CrtkArm from a component.
template <>
class Provided<robots::CrtkArm> : public Provided<suture::Messages> {
  using Contract = robots::CrtkArm;
  using EventId = robots::CrtkArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// The events of robots::CrtkArm, to emit.
  struct Events : Provided<suture::Messages>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<suture::Messages>::Events(provided),
          operating_state{provided, static_cast<std::uint16_t>(EventId::operating_state)},
          desired_state{provided, static_cast<std::uint16_t>(EventId::desired_state)},
          goal_reached{provided, static_cast<std::uint16_t>(EventId::goal_reached)},
          gravity_compensation{provided, static_cast<std::uint16_t>(EventId::gravity_compensation)},
          trajectory_j_ratio{provided, static_cast<std::uint16_t>(EventId::trajectory_j_ratio)},
          trajectory_j_ratio_v{provided, static_cast<std::uint16_t>(EventId::trajectory_j_ratio_v)},
          trajectory_j_ratio_a{provided, static_cast<std::uint16_t>(EventId::trajectory_j_ratio_a)} {}

    /// Each change of the operating state, and the last one to whoever connects.
    Emitter<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// The state that a command asked for.
    Emitter<std::uint8_t, robots::ArmState> desired_state;
    /// A move ended: true at its goal, false when something else replaced it.
    Emitter<std::uint8_t, bool> goal_reached;
    Emitter<std::uint8_t, bool> gravity_compensation;
    Emitter<double, double> trajectory_j_ratio;
    Emitter<double, double> trajectory_j_ratio_v;
    Emitter<double, double> trajectory_j_ratio_a;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : Provided<suture::Messages>(owner, name, info, whole, implementation),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    std::string state_command_name;
    robots::PoseStamped set_base_frame_frame;
    bool use_gravity_compensation_use;
    robots::JointGoal servo_jp_goal;
    robots::JointGoal servo_jr_step;
    robots::JointVelocityGoal servo_jv_goal;
    robots::JointEffortGoal servo_jf_goal;
    robots::PoseStamped servo_cp_goal;
    robots::PoseStamped servo_cr_step;
    robots::TwistGoal servo_cv_goal;
    robots::WrenchGoal body_servo_cf_goal;
    robots::WrenchGoal spatial_servo_cf_goal;
    robots::JointGoal move_jp_goal;
    robots::JointGoal move_jr_step;
    robots::PoseStamped move_cp_goal;
    robots::PoseStamped move_cr_step;
    double trajectory_j_set_ratio_ratio;
    double trajectory_j_set_ratio_v_ratio;
    double trajectory_j_set_ratio_a_ratio;
    robots::JointGoal forward_kinematics_q;
    robots::PoseStamped inverse_kinematics_goal;
    robots::JointGoal query_cp_q;
    robots::JointGoal local_query_cp_q;

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
