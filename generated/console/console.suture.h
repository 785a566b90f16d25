// Written by suturec from console/console.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. console.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "console/console.h"
#include "suture/standard/messages.suture.h"

namespace robots {

bool isKnownConsoleState(std::uint8_t slot);
bool isKnownSystemUse(std::uint8_t slot);

/// Numbers the commands of Console.
struct ConsoleCommand {
  static constexpr std::uint16_t bring_up = 0;
  static constexpr std::uint16_t bring_down = 1;
  static constexpr std::uint16_t console_state = 2;
};

/// Numbers the events of Console, behind those that it inherits.
struct ConsoleEvent {
  static constexpr std::uint16_t console_state = 3;
  static constexpr std::uint16_t system_use = 4;
};

/// Numbers the reads of Console as a row of the state has them.
struct ConsoleColumn {
  static constexpr std::uint16_t console_state = 0;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Console>();

/// Calls robots::Console of another component.
template <>
class Required<robots::Console> : public Required<suture::Messages> {
  using Contract = robots::Console;
  using Id = robots::ConsoleCommand;
  using EventId = robots::ConsoleEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Brings the system up. It is refused, with an error that names each reason, unless the console
  /// is down, every part of the system is there, no arm is in FAULT, and the emergency stop is
  /// released.
  /// Void: up to 16 wait.
  Command<&Contract::bring_up, NoSlot> bring_up{*this, Id::bring_up};
  /// Disables everything in the opposite order, even while the system is being brought up, and
  /// also what others have enabled. An arm in FAULT has no power, and stays in FAULT until somebody
  /// enables or disables it.
  /// Void: up to 16 wait.
  Command<&Contract::bring_down, NoSlot> bring_down{*this, Id::bring_down};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::console_state, std::uint8_t> console_state{*this, Id::console_state};

  /// Subscribes to the events of robots::Console.
  struct Events : Required<suture::Messages>::Events {
    explicit Events(RequiredBase& required)
        : Required<suture::Messages>::Events(required),
          console_state{required, EventId::console_state},
          system_use{required, EventId::system_use} {}

    /// Reports each change, and the last one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::ConsoleState> console_state;
    /// Reports each change, and the present one to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, robots::SystemUse> system_use;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<suture::Messages>(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Console from a component.
template <>
class Provided<robots::Console> : public Provided<suture::Messages> {
  using Contract = robots::Console;
  using EventId = robots::ConsoleEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Console.
  struct Events : Provided<suture::Messages>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<suture::Messages>::Events(provided),
          console_state{provided, EventId::console_state},
          system_use{provided, EventId::system_use} {}

    /// Reports each change, and the last one to a client that connects.
    Emitter<std::uint8_t, robots::ConsoleState> console_state;
    /// Reports each change, and the present one to a client that connects.
    Emitter<std::uint8_t, robots::SystemUse> system_use;
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

  Contract& implementation_;
  Events events_{*this};
};

}  // namespace suture
