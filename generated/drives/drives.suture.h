// Written by suturec from drives/drives.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. drives.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "drives/drives.h"

namespace robots {

/// A DriveFeedback is what the drives measure in each of their cycles. It is of actuators, in the
/// order of the joints of the chain, and of the tool behind them: a slave's jaw, or a master's
/// gripper, which nothing drives. coupling.h says how the actuators of an arm turn its joints; most
/// are their joint. The actuator of a prismatic joint has m, m/s and N.
struct DriveFeedbackSlot {
  std::array<double, 8> position;  // rad
  std::array<double, 8> velocity;  // rad/s
  std::uint32_t joints;
  std::uint8_t power;            // DrivePower
  std::int64_t permitted;        // suture::Time, ns
  std::int64_t stamp;            // suture::Time, ns
  std::array<double, 8> effort;  // N.m
  std::uint8_t measures_effort;  // bool
  std::uint8_t controls_effort;  // bool
};

bool store(const DriveFeedback& value, DriveFeedbackSlot& slot);
void load(const DriveFeedbackSlot& slot, DriveFeedback& value);
void shiftStamps(DriveFeedbackSlot& slot, suture::Duration shift);

/// Says where the actuators shall be, in the same order, and what their motors do beside that. The
/// entry of a gripper has no effect.
struct DriveGoalSlot {
  std::array<double, 8> position;  // rad
  std::uint32_t joints;
  std::array<double, 8> effort;  // N.m
  std::array<std::uint8_t, 8> released;
  std::uint8_t gravity_compensation;  // bool
};

bool store(const DriveGoal& value, DriveGoalSlot& slot);
void load(const DriveGoalSlot& slot, DriveGoal& value);

bool isKnownDrivePower(std::uint8_t slot);
bool isValid(const DriveFeedbackSlot& slot, suture::FieldPath* path);
bool isValid(const DriveGoalSlot& slot, suture::FieldPath* path);

// --- Drives: the arguments of its commands ---

struct DrivesPowerOnArguments {
  std::int64_t permitted;
};

bool store(const std::chrono::steady_clock::time_point& permitted, DrivesPowerOnArguments& slot);
void shiftStamps(DrivesPowerOnArguments& slot, suture::Duration shift);

struct DrivesServoJpArguments {
  DriveGoalSlot goal;
};

bool store(const DriveGoal& goal, DrivesServoJpArguments& slot);

/// Numbers the commands of Drives.
struct DrivesCommand {
  static constexpr std::uint16_t power_on = 0;
  static constexpr std::uint16_t power_off = 1;
  static constexpr std::uint16_t servo_jp = 2;
  static constexpr std::uint16_t feedback = 3;
};

/// Numbers the events of Drives.
struct DrivesEvent {
  static constexpr std::uint16_t power = 0;
};

/// Numbers the reads of Drives as a row of the state has them.
struct DrivesColumn {
  static constexpr std::uint16_t feedback = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::DriveFeedback& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::DriveFeedback& value);

template <>
Result<std::vector<std::byte>> encode(const robots::DriveGoal& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::DriveGoal& value);

template <>
const InterfaceInfo& interfaceInfo<robots::Drives>();

/// Calls robots::Drives of another component.
template <>
class Required<robots::Drives> : public RequiredBase {
  using Contract = robots::Drives;
  using Id = robots::DrivesCommand;
  using EventId = robots::DrivesEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Releases the brakes. The joints hold where they are. `permitted` is that of the feedback that
  /// this answers: drives that have stopped since then, or may not have power, stay as they are.
  /// Write: up to 16 wait.
  Command<&Contract::power_on, robots::DrivesPowerOnArguments> power_on{*this, Id::power_on};
  /// Lets the brakes hold the joints where they are. The joints of an arm that has none sink by
  /// their weight.
  /// Void: up to 16 wait.
  Command<&Contract::power_off, NoSlot> power_off{*this, Id::power_off};
  /// Streams goals, newest wins. Without power, or with the wrong number of joints, a goal changes
  /// nothing. A stream that falls silent for 0.1 s leaves the joints where they are: they are held
  /// there, and no effort of a goal acts any more.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_jp, robots::DrivesServoJpArguments> servo_jp{*this, Id::servo_jp};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::feedback, robots::DriveFeedbackSlot> feedback{*this, Id::feedback};

  /// Subscribes to the events of robots::Drives.
  struct Events {
    explicit Events(RequiredBase& required)
        : power{required, EventId::power} {}

    /// Reports each change, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::DrivePower> power;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Drives from a component.
template <>
class Provided<robots::Drives> : public ProvidedBase {
  using Contract = robots::Drives;
  using EventId = robots::DrivesEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Drives.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : power{provided, EventId::power} {}

    /// Reports each change, and the last one to a client that connects.
    Emitter<std::uint8_t, robots::DrivePower> power;
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
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    std::chrono::steady_clock::time_point power_on_permitted{};
    robots::DriveGoal servo_jp_goal{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
