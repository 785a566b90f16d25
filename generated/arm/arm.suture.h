// Written by suturec from arm/arm.h. Do not edit.
#pragma once

#include <suture/base/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "arm/arm.h"
#include "robot_types/joints.suture.h"
#include "robot_types/operating_state.suture.h"
#include "robot_types/pose.suture.h"

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

/// The numbers of Arm's commands in every table and record.
enum class ArmCommand : std::uint16_t {
  enable,
  disable,
  home,
  hold,
  servo_cp,
  servo_jp,
  move_jp,
  measured_js,
  setpoint_js,
  measured_cp,
  setpoint_cp,
  operating_state,
  forward_kinematics,
  inverse_kinematics,
};

/// The numbers of Arm's events.
enum class ArmEvent : std::uint16_t {
  operating_state,
  goal_reached,
  warning,
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>();

/// What a client of robots::Arm calls.
template <>
class Required<robots::Arm> : public RequiredBase {
  using Contract = robots::Arm;
  using Id = robots::ArmCommand;
  using EventId = robots::ArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Gives the drives power; the arm holds its position.
  Command<&Contract::enable, NoSlot> enable{*this, static_cast<std::uint16_t>(Id::enable)};
  /// Stops at once, without power, and ignores motion until enabled again.
  Command<&Contract::disable, NoSlot> disable{*this, static_cast<std::uint16_t>(Id::disable)};
  /// Moves to the home position; needs an enabled arm. Ends with goal_reached.
  Command<&Contract::home, NoSlot> home{*this, static_cast<std::uint16_t>(Id::home)};
  /// Drops what is under way; the set-point stays where it is.
  Command<&Contract::hold, NoSlot> hold{*this, static_cast<std::uint16_t>(Id::hold)};
  /// Streams Cartesian goals, newest wins. Beyond a joint limit the arm slides along that, at the
  /// nearest that the limits leave; a goal out of reach, or too far for one step, leaves the
  /// set-point. All three it says in `warning`. setpoint_cp keeps the goal's stamp.
  Command<&Contract::servo_cp, robots::ArmServoCpArguments> servo_cp{
      *this, static_cast<std::uint16_t>(Id::servo_cp)};
  /// Streams joint goals, newest wins. A joint whose goal lies beyond its limit stays at that.
  Command<&Contract::servo_jp, robots::ArmServoJpArguments> servo_jp{
      *this, static_cast<std::uint16_t>(Id::servo_jp)};
  /// Plans and executes a smooth motion from the set-point. Ends with goal_reached.
  Command<&Contract::move_jp, robots::ArmMoveJpArguments> move_jp{
      *this, static_cast<std::uint16_t>(Id::move_jp)};
  /// Where the joints are. Stamp: the drives' cycle that measured them.
  ReadCommand<&Contract::measured_js, robots::JointStateSlot> measured_js{
      *this, static_cast<std::uint16_t>(Id::measured_js)};
  /// Where the joints shall be.
  ReadCommand<&Contract::setpoint_js, robots::JointStateSlot> setpoint_js{
      *this, static_cast<std::uint16_t>(Id::setpoint_js)};
  /// Where the tool tip is. Stamp: the drives' cycle that measured the joints.
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{
      *this, static_cast<std::uint16_t>(Id::measured_cp)};
  /// Where the tool tip shall be. Stamp: that of the servo_cp goal it came from, else the arm's
  /// cycle.
  ReadCommand<&Contract::setpoint_cp, robots::PoseStampedSlot> setpoint_cp{
      *this, static_cast<std::uint16_t>(Id::setpoint_cp)};
  ReadCommand<&Contract::operating_state, robots::OperatingStateSlot> operating_state{
      *this, static_cast<std::uint16_t>(Id::operating_state)};
  /// The tool tip for a joint vector; not valid if it has the wrong length.
  QualifiedReadCommand<&Contract::forward_kinematics, robots::ArmForwardKinematicsArguments,
                       robots::PoseStampedSlot> forward_kinematics{
      *this, static_cast<std::uint16_t>(Id::forward_kinematics)};
  /// A joint vector for a tool tip, searched from the present set-point.
  QualifiedReadCommand<&Contract::inverse_kinematics, robots::ArmInverseKinematicsArguments,
                       robots::JointSolutionSlot> inverse_kinematics{
      *this, static_cast<std::uint16_t>(Id::inverse_kinematics)};

  /// The events of robots::Arm, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : operating_state{required, static_cast<std::uint16_t>(EventId::operating_state)},
          goal_reached{required, static_cast<std::uint16_t>(EventId::goal_reached)},
          warning{required, static_cast<std::uint16_t>(EventId::warning)} {}

    /// Each change of the operating state, and the last one to whoever connects.
    Subscription<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// A move ended: true at its goal, false when something else replaced it.
    Subscription<std::uint8_t, bool> goal_reached;
    /// The arm refused a command, or something has befallen it. Each reason is told once until the
    /// arm obeys again; a refused state command is told each time.
    Subscription<std::uint8_t, robots::ArmWarning> warning;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// What serves robots::Arm from a component.
template <>
class Provided<robots::Arm> : public ProvidedBase {
  using Contract = robots::Arm;
  using EventId = robots::ArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// The events of robots::Arm, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : operating_state{provided, static_cast<std::uint16_t>(EventId::operating_state)},
          goal_reached{provided, static_cast<std::uint16_t>(EventId::goal_reached)},
          warning{provided, static_cast<std::uint16_t>(EventId::warning)} {}

    /// Each change of the operating state, and the last one to whoever connects.
    Emitter<robots::OperatingStateSlot, robots::OperatingState> operating_state;
    /// A move ended: true at its goal, false when something else replaced it.
    Emitter<std::uint8_t, bool> goal_reached;
    /// The arm refused a command, or something has befallen it. Each reason is told once until the
    /// arm obeys again; a refused state command is told each time.
    Emitter<std::uint8_t, robots::ArmWarning> warning;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    robots::PoseStamped servo_cp_goal;
    robots::JointGoal servo_jp_goal;
    robots::JointGoal move_jp_goal;
    robots::JointGoal forward_kinematics_q;
    robots::PoseStamped inverse_kinematics_goal;

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
