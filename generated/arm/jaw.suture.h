// Written by suturec from arm/jaw.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. jaw.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "arm/jaw.h"
#include "robot_types/joint_commands.suture.h"
#include "robot_types/joints.suture.h"
#include "suture/standard/messages.suture.h"

namespace robots {

// --- Jaw: the arguments of its commands ---

struct JawServoJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, JawServoJpArguments& slot);
void shiftStamps(JawServoJpArguments& slot, suture::Duration shift);

struct JawServoJfArguments {
  JointEffortGoalSlot goal;
};

bool store(const JointEffortGoal& goal, JawServoJfArguments& slot);
void shiftStamps(JawServoJfArguments& slot, suture::Duration shift);

struct JawMoveJpArguments {
  JointGoalSlot goal;
};

bool store(const JointGoal& goal, JawMoveJpArguments& slot);
void shiftStamps(JawMoveJpArguments& slot, suture::Duration shift);

/// Numbers the commands of Jaw.
struct JawCommand {
  static constexpr std::uint16_t configuration_js = 0;
  static constexpr std::uint16_t measured_js = 1;
  static constexpr std::uint16_t setpoint_js = 2;
  static constexpr std::uint16_t servo_jp = 3;
  static constexpr std::uint16_t servo_jf = 4;
  static constexpr std::uint16_t move_jp = 5;
};

/// Numbers the events of Jaw, behind those that it inherits.
struct JawEvent {
  static constexpr std::uint16_t goal_reached = 3;
};

/// Numbers the reads of Jaw as a row of the state has them.
struct JawColumn {
  static constexpr std::uint16_t configuration_js = 0;
  static constexpr std::uint16_t measured_js = 1;
  static constexpr std::uint16_t setpoint_js = 2;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Jaw>();

/// Calls robots::Jaw of another component.
template <>
class Required<robots::Jaw> : public Required<suture::Messages> {
  using Contract = robots::Jaw;
  using Id = robots::JawCommand;
  using EventId = robots::JawEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Says what the joint is and what it may do. Its effort limit is published
  /// (LARGE_NEEDLE_DRIVER_400006.json); its acceleration limit, which is that of moves, is not.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::configuration_js, robots::JointConfigurationSlot> configuration_js{
      *this, Id::configuration_js};
  /// Says where the joint is. The stamp is that of the drives' cycle that measured it.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_js, robots::JointStateSlot> measured_js{*this, Id::measured_js};
  /// Says where the joint shall be. The effort is that of servo_jf, else 0.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::setpoint_js, robots::JointStateSlot> setpoint_js{*this, Id::setpoint_js};
  /// Streams goals, newest wins. The set-point goes there no faster than the joint can; a goal
  /// beyond a limit leads only to the limit.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jp, robots::JawServoJpArguments> servo_jp{*this, Id::servo_jp};
  /// Streams efforts, newest wins; a negative one closes. The simulated jaw has no mass: an effort
  /// moves the set-point at a speed proportional to it.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jf, robots::JawServoJfArguments> servo_jf{*this, Id::servo_jf};
  /// Plans and executes a smooth motion from the set-point and the velocity that it has. Ends with
  /// goal_reached.
  /// Write: up to 16 wait.
  Command<&Contract::move_jp, robots::JawMoveJpArguments> move_jp{*this, Id::move_jp};

  /// Subscribes to the events of robots::Jaw.
  struct Events : Required<suture::Messages>::Events {
    explicit Events(RequiredBase& required)
        : Required<suture::Messages>::Events(required),
          goal_reached{required, EventId::goal_reached} {}

    /// Reports the end of a move: true at its goal, false if something else replaced it.
    /// At a subscriber up to 16 wait.
    Subscription<std::uint8_t, bool> goal_reached;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<suture::Messages>(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Jaw from a component.
template <>
class Provided<robots::Jaw> : public Provided<suture::Messages> {
  using Contract = robots::Jaw;
  using EventId = robots::JawEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Jaw.
  struct Events : Provided<suture::Messages>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<suture::Messages>::Events(provided),
          goal_reached{provided, EventId::goal_reached} {}

    /// Reports the end of a move: true at its goal, false if something else replaced it.
    Emitter<std::uint8_t, bool> goal_reached;
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
    robots::JointGoal servo_jp_goal{};
    robots::JointEffortGoal servo_jf_goal{};
    robots::JointGoal move_jp_goal{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
