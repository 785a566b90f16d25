// Written by suturec from arm/arm.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. arm.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "arm/arm.h"
#include "robot_types/cartesian.suture.h"
#include "robot_types/joint_commands.suture.h"
#include "robot_types/joints.suture.h"
#include "robot_types/messages.suture.h"
#include "robot_types/operating_state.suture.h"
#include "robot_types/pose.suture.h"
#include "suture/standard/messages.suture.h"

namespace robots {

// --- Arm: the arguments of its commands ---

struct ArmServoCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmServoCpArguments& slot);
void shiftStamps(ArmServoCpArguments& slot, suture::Duration shift);

struct ArmServoJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, ArmServoJpArguments& slot);
void shiftStamps(ArmServoJpArguments& slot, suture::Duration shift);

struct ArmMoveJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, ArmMoveJpArguments& slot);
void shiftStamps(ArmMoveJpArguments& slot, suture::Duration shift);

struct ArmForwardKinematicsArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, ArmForwardKinematicsArguments& slot);
void shiftStamps(ArmForwardKinematicsArguments& slot, suture::Duration shift);

struct ArmInverseKinematicsArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmInverseKinematicsArguments& slot);
void shiftStamps(ArmInverseKinematicsArguments& slot, suture::Duration shift);

struct ArmStateCommandArguments {
  suture::BoundedText<15> name;
};

bool store(const std::string& name, ArmStateCommandArguments& slot);

struct ArmSetBaseFrameArguments {
  TransformStampedSlot base;
};

bool store(const TransformStamped& base, ArmSetBaseFrameArguments& slot);
void shiftStamps(ArmSetBaseFrameArguments& slot, suture::Duration shift);

struct ArmUseGravityCompensationArguments {
  std::uint8_t use;
};

bool store(const bool& use, ArmUseGravityCompensationArguments& slot);

struct ArmServoJrArguments {
  JointGoalSlot step;
};

bool store(const JointGoal& step, ArmServoJrArguments& slot);
void shiftStamps(ArmServoJrArguments& slot, suture::Duration shift);

struct ArmServoJvArguments {
  JointVelocityGoalSlot goal;
};

bool store(const JointVelocityGoal& goal, ArmServoJvArguments& slot);
void shiftStamps(ArmServoJvArguments& slot, suture::Duration shift);

struct ArmServoJfArguments {
  JointEffortGoalSlot goal;
};

bool store(const JointEffortGoal& goal, ArmServoJfArguments& slot);
void shiftStamps(ArmServoJfArguments& slot, suture::Duration shift);

struct ArmServoCrArguments {
  PoseStampedSlot step;
};

bool store(const PoseStamped& step, ArmServoCrArguments& slot);
void shiftStamps(ArmServoCrArguments& slot, suture::Duration shift);

struct ArmServoCvArguments {
  TwistGoalSlot goal;
};

bool store(const TwistGoal& goal, ArmServoCvArguments& slot);
void shiftStamps(ArmServoCvArguments& slot, suture::Duration shift);

struct ArmBodyServoCfArguments {
  WrenchGoalSlot goal;
};

bool store(const WrenchGoal& goal, ArmBodyServoCfArguments& slot);
void shiftStamps(ArmBodyServoCfArguments& slot, suture::Duration shift);

struct ArmSpatialServoCfArguments {
  WrenchGoalSlot goal;
};

bool store(const WrenchGoal& goal, ArmSpatialServoCfArguments& slot);
void shiftStamps(ArmSpatialServoCfArguments& slot, suture::Duration shift);

struct ArmInterpolateJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, ArmInterpolateJpArguments& slot);
void shiftStamps(ArmInterpolateJpArguments& slot, suture::Duration shift);

struct ArmInterpolateJrArguments {
  JointGoalSlot step;
};

bool store(const JointGoal& step, ArmInterpolateJrArguments& slot);
void shiftStamps(ArmInterpolateJrArguments& slot, suture::Duration shift);

struct ArmInterpolateCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmInterpolateCpArguments& slot);
void shiftStamps(ArmInterpolateCpArguments& slot, suture::Duration shift);

struct ArmInterpolateCrArguments {
  PoseStampedSlot step;
};

bool store(const PoseStamped& step, ArmInterpolateCrArguments& slot);
void shiftStamps(ArmInterpolateCrArguments& slot, suture::Duration shift);

struct ArmMoveJrArguments {
  JointGoalSlot step;
};

bool store(const JointGoal& step, ArmMoveJrArguments& slot);
void shiftStamps(ArmMoveJrArguments& slot, suture::Duration shift);

struct ArmMoveCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmMoveCpArguments& slot);
void shiftStamps(ArmMoveCpArguments& slot, suture::Duration shift);

struct ArmMoveCrArguments {
  PoseStampedSlot step;
};

bool store(const PoseStamped& step, ArmMoveCrArguments& slot);
void shiftStamps(ArmMoveCrArguments& slot, suture::Duration shift);

struct ArmTrajectoryJSetRatioArguments {
  double ratio;
};

bool store(const double& ratio, ArmTrajectoryJSetRatioArguments& slot);

struct ArmTrajectoryJSetRatioVArguments {
  double ratio;
};

bool store(const double& ratio, ArmTrajectoryJSetRatioVArguments& slot);

struct ArmTrajectoryJSetRatioAArguments {
  double ratio;
};

bool store(const double& ratio, ArmTrajectoryJSetRatioAArguments& slot);

struct ArmQueryCpArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, ArmQueryCpArguments& slot);
void shiftStamps(ArmQueryCpArguments& slot, suture::Duration shift);

struct ArmLocalQueryCpArguments {
  JointGoalSlot q;
};

bool store(const JointGoal& q, ArmLocalQueryCpArguments& slot);
void shiftStamps(ArmLocalQueryCpArguments& slot, suture::Duration shift);

/// Numbers the commands of Arm.
struct ArmCommand {
  static constexpr std::uint16_t enable = 0;
  static constexpr std::uint16_t disable = 1;
  static constexpr std::uint16_t home = 2;
  static constexpr std::uint16_t hold = 3;
  static constexpr std::uint16_t servo_cp = 4;
  static constexpr std::uint16_t servo_jp = 5;
  static constexpr std::uint16_t move_jp = 6;
  static constexpr std::uint16_t measured_js = 7;
  static constexpr std::uint16_t setpoint_js = 8;
  static constexpr std::uint16_t measured_cp = 9;
  static constexpr std::uint16_t setpoint_cp = 10;
  static constexpr std::uint16_t operating_state = 11;
  static constexpr std::uint16_t forward_kinematics = 12;
  static constexpr std::uint16_t inverse_kinematics = 13;
  static constexpr std::uint16_t configuration_js = 14;
  static constexpr std::uint16_t period_statistics = 15;
  static constexpr std::uint16_t pause = 16;
  static constexpr std::uint16_t resume = 17;
  static constexpr std::uint16_t unhome = 18;
  static constexpr std::uint16_t state_command = 19;
  static constexpr std::uint16_t goal_js = 20;
  static constexpr std::uint16_t goal_cp = 21;
  static constexpr std::uint16_t local_measured_cp = 22;
  static constexpr std::uint16_t local_setpoint_cp = 23;
  static constexpr std::uint16_t measured_cv = 24;
  static constexpr std::uint16_t setpoint_cv = 25;
  static constexpr std::uint16_t body_measured_cf = 26;
  static constexpr std::uint16_t spatial_measured_cf = 27;
  static constexpr std::uint16_t measured_cs = 28;
  static constexpr std::uint16_t body_jacobian = 29;
  static constexpr std::uint16_t spatial_jacobian = 30;
  static constexpr std::uint16_t base_frame = 31;
  static constexpr std::uint16_t set_base_frame = 32;
  static constexpr std::uint16_t free = 33;
  static constexpr std::uint16_t use_gravity_compensation = 34;
  static constexpr std::uint16_t servo_jr = 35;
  static constexpr std::uint16_t servo_jv = 36;
  static constexpr std::uint16_t servo_jf = 37;
  static constexpr std::uint16_t servo_cr = 38;
  static constexpr std::uint16_t servo_cv = 39;
  static constexpr std::uint16_t body_servo_cf = 40;
  static constexpr std::uint16_t spatial_servo_cf = 41;
  static constexpr std::uint16_t interpolate_jp = 42;
  static constexpr std::uint16_t interpolate_jr = 43;
  static constexpr std::uint16_t interpolate_cp = 44;
  static constexpr std::uint16_t interpolate_cr = 45;
  static constexpr std::uint16_t move_jr = 46;
  static constexpr std::uint16_t move_cp = 47;
  static constexpr std::uint16_t move_cr = 48;
  static constexpr std::uint16_t trajectory_j_set_ratio = 49;
  static constexpr std::uint16_t trajectory_j_set_ratio_v = 50;
  static constexpr std::uint16_t trajectory_j_set_ratio_a = 51;
  static constexpr std::uint16_t trajectory_j_ratio = 52;
  static constexpr std::uint16_t trajectory_j_ratio_v = 53;
  static constexpr std::uint16_t trajectory_j_ratio_a = 54;
  static constexpr std::uint16_t query_cp = 55;
  static constexpr std::uint16_t local_query_cp = 56;
};

/// Numbers the events of Arm, behind those that it inherits.
struct ArmEvent {
  static constexpr std::uint16_t operating_state = 3;
  static constexpr std::uint16_t goal_reached = 4;
  static constexpr std::uint16_t desired_state = 5;
  static constexpr std::uint16_t gravity_compensation = 6;
  static constexpr std::uint16_t trajectory_j_ratio = 7;
  static constexpr std::uint16_t trajectory_j_ratio_v = 8;
  static constexpr std::uint16_t trajectory_j_ratio_a = 9;
};

/// Numbers the reads of Arm as a row of the state has them.
struct ArmColumn {
  static constexpr std::uint16_t measured_js = 0;
  static constexpr std::uint16_t setpoint_js = 1;
  static constexpr std::uint16_t measured_cp = 2;
  static constexpr std::uint16_t setpoint_cp = 3;
  static constexpr std::uint16_t operating_state = 4;
  static constexpr std::uint16_t configuration_js = 5;
  static constexpr std::uint16_t period_statistics = 6;
  static constexpr std::uint16_t goal_js = 7;
  static constexpr std::uint16_t goal_cp = 8;
  static constexpr std::uint16_t local_measured_cp = 9;
  static constexpr std::uint16_t local_setpoint_cp = 10;
  static constexpr std::uint16_t measured_cv = 11;
  static constexpr std::uint16_t setpoint_cv = 12;
  static constexpr std::uint16_t body_measured_cf = 13;
  static constexpr std::uint16_t spatial_measured_cf = 14;
  static constexpr std::uint16_t measured_cs = 15;
  static constexpr std::uint16_t body_jacobian = 16;
  static constexpr std::uint16_t spatial_jacobian = 17;
  static constexpr std::uint16_t base_frame = 18;
  static constexpr std::uint16_t trajectory_j_ratio = 19;
  static constexpr std::uint16_t trajectory_j_ratio_v = 20;
  static constexpr std::uint16_t trajectory_j_ratio_a = 21;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>();

/// Calls robots::Arm of another component.
template <>
class Required<robots::Arm> : public Required<suture::Messages> {
  using Contract = robots::Arm;
  using Id = robots::ArmCommand;
  using EventId = robots::ArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Gives the drives power. The arm holds its position.
  /// Void: up to 16 wait.
  Command<&Contract::enable, NoSlot> enable{*this, Id::enable};
  /// Stops the arm at once and takes its power. It refuses motion until it is enabled again.
  /// Void: up to 16 wait.
  Command<&Contract::disable, NoSlot> disable{*this, Id::disable};
  /// Moves the arm to its home position, if it is enabled. The move ends with goal_reached.
  /// Void: up to 16 wait.
  Command<&Contract::home, NoSlot> home{*this, Id::home};
  /// Drops what is under way; the set-point stays where it is.
  /// Void: up to 16 wait.
  Command<&Contract::hold, NoSlot> hold{*this, Id::hold};
  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along it, at the
  /// nearest point that the limits admit, and warns of AtLimit. A goal that is out of reach, or
  /// farther from the set-point than the rate limits admit, is dropped with a warning, OutOfReach
  /// or StepTooFar, and the set-point stays where it was. setpoint_cp keeps the goal's stamp.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_cp, robots::ArmServoCpArguments> servo_cp{*this, Id::servo_cp};
  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at the limit.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jp, robots::ArmServoJpArguments> servo_jp{*this, Id::servo_jp};
  /// Plans and executes a smooth motion of the joints from the set-point, and from the velocity
  /// that it has: a move may replace another under way. It ends at rest and with goal_reached. A
  /// goal beyond a joint limit is refused.
  /// Write: up to 16 wait.
  Command<&Contract::move_jp, robots::ArmMoveJpArguments> move_jp{*this, Id::move_jp};
  /// Says where the joints are, and what their motors give; `effort` is empty if the drives do not
  /// measure it. The stamp is that of the drives' cycle that measured them.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_js, robots::JointStateSlot> measured_js{*this, Id::measured_js};
  /// Says where the joints are commanded to be in this cycle.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::setpoint_js, robots::JointStateSlot> setpoint_js{*this, Id::setpoint_js};
  /// Says where the tool tip is. The stamp is that of the drives' cycle that measured the joints.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{*this, Id::measured_cp};
  /// Says where the tool tip is commanded to be in this cycle. The stamp is that of the servo_cp or
  /// interpolate_cp goal from which it came, else that of the arm's cycle.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::setpoint_cp, robots::PoseStampedSlot> setpoint_cp{*this, Id::setpoint_cp};
  /// Says in which state of CRTK the arm is, and whether it is homed.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::operating_state, robots::OperatingStateSlot> operating_state{
      *this, Id::operating_state};
  /// Computes the tool tip for a joint vector; it is not valid if the vector has the wrong length.
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::forward_kinematics, robots::ArmForwardKinematicsArguments,
                       robots::PoseStampedSlot> forward_kinematics{*this, Id::forward_kinematics};
  /// Computes a joint vector for a tool tip, searched from the present set-point.
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::inverse_kinematics, robots::ArmInverseKinematicsArguments,
                       robots::JointSolutionSlot> inverse_kinematics{*this, Id::inverse_kinematics};
  /// Says what the joints are and what they may do. Velocities are their rate limits, accelerations
  /// those of moves, efforts the most that the motors give. For a da Vinci the efforts are from the
  /// literature, the accelerations our own. A list is empty if it bounds no joint.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::configuration_js, robots::JointConfigurationSlot> configuration_js{
      *this, Id::configuration_js};
  /// Says how regularly the arm's task ran in the last second.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::period_statistics, robots::IntervalStatisticsSlot> period_statistics{
      *this, Id::period_statistics};
  /// Stops the arm where the joints are. It refuses motion until resume().
  /// Void: up to 16 wait.
  Command<&Contract::pause, NoSlot> pause{*this, Id::pause};
  /// Ends a pause: the arm is enabled and holds.
  /// Void: up to 16 wait.
  Command<&Contract::resume, NoSlot> resume{*this, Id::resume};
  /// Makes the arm forget that it is homed, and ends home(): the arm holds where it is.
  /// Void: up to 16 wait.
  Command<&Contract::unhome, NoSlot> unhome{*this, Id::unhome};
  /// Does what its name says: "enable", "disable", "pause", "resume", "home" or "unhome". Any other
  /// name is reported as an error.
  /// Write: up to 16 wait.
  Command<&Contract::state_command, robots::ArmStateCommandArguments> state_command{
      *this, Id::state_command};
  /// Says where the present move ends; without one, it is the set-point.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::goal_js, robots::JointStateSlot> goal_js{*this, Id::goal_js};
  /// Says where the present move ends; without one, it is the set-point.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::goal_cp, robots::PoseStampedSlot> goal_cp{*this, Id::goal_cp};
  /// Says where the tool tip is in the arm's base frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::local_measured_cp, robots::PoseStampedSlot> local_measured_cp{
      *this, Id::local_measured_cp};
  /// Says where the tool tip is commanded to be, in the arm's base frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::local_setpoint_cp, robots::PoseStampedSlot> local_setpoint_cp{
      *this, Id::local_setpoint_cp};
  /// Says how the tip moves, in the directions of the reference frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cv, robots::TwistSlot> measured_cv{*this, Id::measured_cv};
  /// Says how the set-point moves, whatever moves it, in the directions of the reference frame. If
  /// it jumped, and in the first cycle of a motion, this is 0. The stamp is that of the arm's
  /// cycle.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::setpoint_cv, robots::TwistSlot> setpoint_cv{*this, Id::setpoint_cv};
  /// Says with which wrench the arm presses at its tip, in the tip's own directions: the motors'
  /// efforts, less the arm's weight by its model, through the transposed Jacobian. It includes
  /// friction, inertia and the errors of that model, so it is near a contact's force only if the
  /// arm is slow and presses hard. Its sign is that of body_servo_cf, as in the da Vinci Research
  /// Kit; what touches the tip presses on it with the opposite. It is not valid if the drives
  /// measure no effort, without power, and near a singularity. The stamp is that of the drives'
  /// cycle that measured the joints.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::body_measured_cf, robots::WrenchSlot> body_measured_cf{
      *this, Id::body_measured_cf};
  /// Says what body_measured_cf says, in the directions of the arm's base frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::spatial_measured_cf, robots::WrenchSlot> spatial_measured_cf{
      *this, Id::spatial_measured_cf};
  /// Gives pose, velocity and force of one cycle, in the reference frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cs, robots::CartesianStateSlot> measured_cs{
      *this, Id::measured_cs};
  /// Maps joint velocities to the velocity of the tip, in the tip's own directions. The stamp is
  /// that of the drives' cycle that measured the joints.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::body_jacobian, robots::JacobianSlot> body_jacobian{
      *this, Id::body_jacobian};
  /// Maps joint velocities to the velocity of the tip, in the directions of the arm's base frame.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::spatial_jacobian, robots::JacobianSlot> spatial_jacobian{
      *this, Id::spatial_jacobian};
  /// Says where the arm's base is in the reference frame of this interface.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::base_frame, robots::TransformStampedSlot> base_frame{
      *this, Id::base_frame};
  /// Sets where the arm's base is in the reference frame of this interface, for all clients. It is
  /// refused if `base` names another reference frame than the interface's, while the arm moves or
  /// follows a stream, and until no goal of a Cartesian stream in the reference frame, obeyed or
  /// refused, has come for 0.1 s: the next one would be about the previous base.
  /// Write: up to 16 wait.
  Command<&Contract::set_base_frame, robots::ArmSetBaseFrameArguments> set_base_frame{
      *this, Id::set_base_frame};
  /// Lets the set-point follow the joints until another command. Drives that control efforts
  /// release the joints: their motors do no more than carry the arm, if they are to.
  /// Void: up to 16 wait.
  Command<&Contract::free, NoSlot> free{*this, Id::free};
  /// Says if the motors carry the arm's weight, in every state that has power; at first they do.
  /// Drives that control efforts obey it. Without it a joint that is held sinks until its
  /// controller carries it, and one that is released falls.
  /// Write: up to 16 wait.
  Command<&Contract::use_gravity_compensation,
          robots::ArmUseGravityCompensationArguments> use_gravity_compensation{
      *this, Id::use_gravity_compensation};
  /// Steps the set-point by joint positions.
  /// Write: up to 16 wait. Not executed if it was sent more than 20 ms ago.
  Command<&Contract::servo_jr, robots::ArmServoJrArguments> servo_jr{*this, Id::servo_jr};
  /// Streams joint velocities, newest wins: the set-point moves so fast, within the rate limits.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jv, robots::ArmServoJvArguments> servo_jv{*this, Id::servo_jv};
  /// Streams what the motors give beside carrying the arm, newest wins. The joints are released;
  /// those outside of the mask are held. If the drives control no effort, it moves the set-point at
  /// a speed proportional to it.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jf, robots::ArmServoJfArguments> servo_jf{*this, Id::servo_jf};
  /// Steps the set-point: the translation is in the reference frame, the rotation turns the tip
  /// about itself.
  /// Write: up to 16 wait. Not executed if it was sent more than 20 ms ago.
  Command<&Contract::servo_cr, robots::ArmServoCrArguments> servo_cr{*this, Id::servo_cr};
  /// Streams velocities of the tip, in the directions of the reference frame, newest wins.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_cv, robots::ArmServoCvArguments> servo_cv{*this, Id::servo_cv};
  /// Streams the wrench that the tip presses with beside carrying the arm, in the tip's own
  /// directions, newest wins. The joints are released as by servo_jf; drives that control no effort
  /// move the set-point at a speed proportional to the wrench.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::body_servo_cf, robots::ArmBodyServoCfArguments> body_servo_cf{
      *this, Id::body_servo_cf};
  /// Streams wrenches as body_servo_cf does, in the directions of the arm's base frame.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::spatial_servo_cf, robots::ArmSpatialServoCfArguments> spatial_servo_cf{
      *this, Id::spatial_servo_cf};
  /// Streams goals that come more slowly than the arm's cycles, newest wins. The set-point goes to
  /// each in a straight line of the joints, in as much time as lay between it and the goal before
  /// it, but no faster than the joints can, and stays there. Limits and reach are those of servo
  /// commands.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 200 ms
  /// ago.
  Command<&Contract::interpolate_jp, robots::ArmInterpolateJpArguments> interpolate_jp{
      *this, Id::interpolate_jp};
  /// Steps the goal of interpolate_jp by joint positions.
  /// Write: up to 16 wait. Not executed if it was sent more than 200 ms ago.
  Command<&Contract::interpolate_jr, robots::ArmInterpolateJrArguments> interpolate_jr{
      *this, Id::interpolate_jr};
  /// Streams Cartesian goals that come more slowly than the arm's cycles, as interpolate_jp does.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 200 ms
  /// ago.
  Command<&Contract::interpolate_cp, robots::ArmInterpolateCpArguments> interpolate_cp{
      *this, Id::interpolate_cp};
  /// Steps the goal of interpolate_cp as servo_cr steps the set-point.
  /// Write: up to 16 wait. Not executed if it was sent more than 200 ms ago.
  Command<&Contract::interpolate_cr, robots::ArmInterpolateCrArguments> interpolate_cr{
      *this, Id::interpolate_cr};
  /// Moves as move_jp does, by joint positions from the set-point.
  /// Write: up to 16 wait.
  Command<&Contract::move_jr, robots::ArmMoveJrArguments> move_jr{*this, Id::move_jr};
  /// Moves the tip to a pose, by the motion of the joints that move_jp plans: the path is not
  /// straight in space. A goal that the joints cannot reach within their limits is refused.
  /// Write: up to 16 wait.
  Command<&Contract::move_cp, robots::ArmMoveCpArguments> move_cp{*this, Id::move_cp};
  /// Moves as move_cp does, by a step from the set-point that is given as servo_cr's.
  /// Write: up to 16 wait.
  Command<&Contract::move_cr, robots::ArmMoveCrArguments> move_cr{*this, Id::move_cr};
  /// Sets the fraction of the joints' velocity and acceleration limits that moves use.
  /// Write: up to 16 wait. `ratio` is from 0.01 to 1.
  Command<&Contract::trajectory_j_set_ratio,
          robots::ArmTrajectoryJSetRatioArguments> trajectory_j_set_ratio{
      *this, Id::trajectory_j_set_ratio};
  /// Sets the fraction of the velocity limits alone.
  /// Write: up to 16 wait. `ratio` is from 0.01 to 1.
  Command<&Contract::trajectory_j_set_ratio_v,
          robots::ArmTrajectoryJSetRatioVArguments> trajectory_j_set_ratio_v{
      *this, Id::trajectory_j_set_ratio_v};
  /// Sets the fraction of the acceleration limits alone.
  /// Write: up to 16 wait. `ratio` is from 0.01 to 1.
  Command<&Contract::trajectory_j_set_ratio_a,
          robots::ArmTrajectoryJSetRatioAArguments> trajectory_j_set_ratio_a{
      *this, Id::trajectory_j_set_ratio_a};
  /// Says the smaller of trajectory_j_ratio_v and trajectory_j_ratio_a.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::trajectory_j_ratio, double> trajectory_j_ratio{
      *this, Id::trajectory_j_ratio};
  /// Says what trajectory_j_set_ratio_v has set.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::trajectory_j_ratio_v, double> trajectory_j_ratio_v{
      *this, Id::trajectory_j_ratio_v};
  /// Says what trajectory_j_set_ratio_a has set.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::trajectory_j_ratio_a, double> trajectory_j_ratio_a{
      *this, Id::trajectory_j_ratio_a};
  /// Computes the pose of link n for a vector of n joints, at most all of them; that of the base
  /// for an empty one.
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::query_cp, robots::ArmQueryCpArguments,
                       robots::PoseStampedSlot> query_cp{*this, Id::query_cp};
  /// Computes what query_cp does, in the arm's base frame.
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::local_query_cp, robots::ArmLocalQueryCpArguments,
                       robots::PoseStampedSlot> local_query_cp{*this, Id::local_query_cp};

  /// Subscribes to the events of robots::Arm.
  struct Events : Required<suture::Messages>::Events {
    explicit Events(RequiredBase& required)
        : Required<suture::Messages>::Events(required),
          operating_state{required, EventId::operating_state},
          goal_reached{required, EventId::goal_reached},
          desired_state{required, EventId::desired_state},
          gravity_compensation{required, EventId::gravity_compensation},
          trajectory_j_ratio{required, EventId::trajectory_j_ratio},
          trajectory_j_ratio_v{required, EventId::trajectory_j_ratio_v},
          trajectory_j_ratio_a{required, EventId::trajectory_j_ratio_a} {}

    /// Reports each change of the operating state, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// Reports the end of a move: true at its goal, false if anything else ended it.
    /// At a subscriber up to 16 wait.
    Subscription<std::uint8_t, bool> goal_reached;
    /// Reports the state that a command asked for.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::ArmState> desired_state;
    /// Reports what use_gravity_compensation has set.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> gravity_compensation;
    /// Reports a change of the fraction that trajectory_j_ratio says.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<double, double> trajectory_j_ratio;
    /// Reports a change of the fraction of the velocity limits.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<double, double> trajectory_j_ratio_v;
    /// Reports a change of the fraction of the acceleration limits.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
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

/// Serves robots::Arm from a component.
template <>
class Provided<robots::Arm> : public Provided<suture::Messages> {
  using Contract = robots::Arm;
  using EventId = robots::ArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Arm.
  struct Events : Provided<suture::Messages>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<suture::Messages>::Events(provided),
          operating_state{provided, EventId::operating_state},
          goal_reached{provided, EventId::goal_reached},
          desired_state{provided, EventId::desired_state},
          gravity_compensation{provided, EventId::gravity_compensation},
          trajectory_j_ratio{provided, EventId::trajectory_j_ratio},
          trajectory_j_ratio_v{provided, EventId::trajectory_j_ratio_v},
          trajectory_j_ratio_a{provided, EventId::trajectory_j_ratio_a} {}

    /// Reports each change of the operating state, and the last one to a client that connects.
    Emitter<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// Reports the end of a move: true at its goal, false if anything else ended it.
    Emitter<std::uint8_t, bool> goal_reached;
    /// Reports the state that a command asked for.
    Emitter<std::uint8_t, robots::ArmState> desired_state;
    /// Reports what use_gravity_compensation has set.
    Emitter<std::uint8_t, bool> gravity_compensation;
    /// Reports a change of the fraction that trajectory_j_ratio says.
    Emitter<double, double> trajectory_j_ratio;
    /// Reports a change of the fraction of the velocity limits.
    Emitter<double, double> trajectory_j_ratio_v;
    /// Reports a change of the fraction of the acceleration limits.
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
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    robots::PoseStamped servo_cp_goal{};
    robots::JointGoal servo_jp_goal{};
    robots::JointGoal move_jp_goal{};
    robots::JointGoal forward_kinematics_q{};
    robots::PoseStamped inverse_kinematics_goal{};
    std::string state_command_name{};
    robots::TransformStamped set_base_frame_base{};
    bool use_gravity_compensation_use{};
    robots::JointGoal servo_jr_step{};
    robots::JointVelocityGoal servo_jv_goal{};
    robots::JointEffortGoal servo_jf_goal{};
    robots::PoseStamped servo_cr_step{};
    robots::TwistGoal servo_cv_goal{};
    robots::WrenchGoal body_servo_cf_goal{};
    robots::WrenchGoal spatial_servo_cf_goal{};
    robots::JointGoal interpolate_jp_goal{};
    robots::JointGoal interpolate_jr_step{};
    robots::PoseStamped interpolate_cp_goal{};
    robots::PoseStamped interpolate_cr_step{};
    robots::JointGoal move_jr_step{};
    robots::PoseStamped move_cp_goal{};
    robots::PoseStamped move_cr_step{};
    double trajectory_j_set_ratio_ratio{};
    double trajectory_j_set_ratio_v_ratio{};
    double trajectory_j_set_ratio_a_ratio{};
    robots::JointGoal query_cp_q{};
    robots::JointGoal local_query_cp_q{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
