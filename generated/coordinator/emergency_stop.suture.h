// Written by suturec from coordinator/emergency_stop.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. emergency_stop.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "coordinator/emergency_stop.h"

namespace robots {

/// Lets drives have power. It counts only as long as it is fresh, so that drives that do not
/// receive it any more stop too.
struct PermitSlot {
  std::uint8_t granted;  // bool
  std::int64_t stamp;    // suture::Time, ns
  std::uint64_t press;
};

bool store(const Permit& value, PermitSlot& slot);
void load(const PermitSlot& slot, Permit& value);
void shiftStamps(PermitSlot& slot, suture::Duration shift);

/// Says that the emergency stop was pressed, or released.
struct StopNewsSlot {
  std::uint8_t pressed;   // bool
  std::int64_t stamp;     // suture::Time, ns
  std::uint8_t is_start;  // bool
  std::uint64_t press;
};

bool store(const StopNews& value, StopNewsSlot& slot);
void load(const StopNewsSlot& slot, StopNews& value);
void shiftStamps(StopNewsSlot& slot, suture::Duration shift);

bool isValid(const PermitSlot& slot, suture::FieldPath* path);
bool isValid(const StopNewsSlot& slot, suture::FieldPath* path);

// --- EmergencyStop: the arguments of its commands ---

struct EmergencyStopReleaseArguments {
  std::uint64_t press;
};

bool store(const std::uint64_t& press, EmergencyStopReleaseArguments& slot);

/// Numbers the commands of EmergencyStop.
struct EmergencyStopCommand {
  static constexpr std::uint16_t press = 0;
  static constexpr std::uint16_t release = 1;
  static constexpr std::uint16_t permit = 2;
};

/// Numbers the events of EmergencyStop.
struct EmergencyStopEvent {
  static constexpr std::uint16_t stop = 0;
};

/// Numbers the reads of EmergencyStop as a row of the state has them.
struct EmergencyStopColumn {
  static constexpr std::uint16_t permit = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Permit& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Permit& value);

template <>
Result<std::vector<std::byte>> encode(const robots::StopNews& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::StopNews& value);

template <>
const InterfaceInfo& interfaceInfo<robots::EmergencyStop>();

/// Calls robots::EmergencyStop of another component.
template <>
class Required<robots::EmergencyStop> : public RequiredBase {
  using Contract = robots::EmergencyStop;
  using Id = robots::EmergencyStopCommand;
  using EventId = robots::EmergencyStopEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Stops all drives. None has power until release().
  /// Void: up to 16 wait.
  Command<&Contract::press, NoSlot> press{*this, Id::press};
  /// Lets drives have power again, which an operator must have decided. `press` is that of the news
  /// that this answers: it does nothing if somebody has pressed since. Arms stay disabled until
  /// somebody enables them, such as a console that brings its system up by itself.
  /// Write: up to 16 wait.
  Command<&Contract::release, robots::EmergencyStopReleaseArguments> release{*this, Id::release};
  /// The coordinator renews the permit in each cycle.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::permit, robots::PermitSlot> permit{*this, Id::permit};

  /// Subscribes to the events of robots::EmergencyStop.
  struct Events {
    explicit Events(RequiredBase& required)
        : stop{required, EventId::stop} {}

    /// Reports each press and each release, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<robots::StopNewsSlot, robots::StopNews> stop;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::EmergencyStop from a component.
template <>
class Provided<robots::EmergencyStop> : public ProvidedBase {
  using Contract = robots::EmergencyStop;
  using EventId = robots::EmergencyStopEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::EmergencyStop.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : stop{provided, EventId::stop} {}

    /// Reports each press and each release, and the last one to a client that connects.
    Emitter<robots::StopNewsSlot, robots::StopNews> stop;
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
    std::uint64_t release_press{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
