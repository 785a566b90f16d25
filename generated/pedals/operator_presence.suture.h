// Written by suturec from pedals/operator_presence.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. operator_presence.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "pedals/operator_presence.h"

namespace robots {

/// Says if a head is in the viewer. It counts only as long as it is fresh.
struct PresenceSlot {
  std::uint8_t present;  // bool
  std::int64_t stamp;    // suture::Time, ns
};

bool store(const Presence& value, PresenceSlot& slot);
void load(const PresenceSlot& slot, Presence& value);
void shiftStamps(PresenceSlot& slot, suture::Duration shift);

bool isValid(const PresenceSlot& slot, suture::FieldPath* path);

/// Numbers the commands of OperatorPresence.
struct OperatorPresenceCommand {
  static constexpr std::uint16_t presence = 0;
};

/// Numbers the events of OperatorPresence.
struct OperatorPresenceEvent {
  static constexpr std::uint16_t operator_present = 0;
};

/// Numbers the reads of OperatorPresence as a row of the state has them.
struct OperatorPresenceColumn {
  static constexpr std::uint16_t presence = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Presence& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Presence& value);

template <>
const InterfaceInfo& interfaceInfo<robots::OperatorPresence>();

/// Calls robots::OperatorPresence of another component.
template <>
class Required<robots::OperatorPresence> : public RequiredBase {
  using Contract = robots::OperatorPresence;
  using Id = robots::OperatorPresenceCommand;
  using EventId = robots::OperatorPresenceEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::presence, robots::PresenceSlot> presence{*this, Id::presence};

  /// Subscribes to the events of robots::OperatorPresence.
  struct Events {
    explicit Events(RequiredBase& required)
        : operator_present{required, EventId::operator_present} {}

    /// Reports each change, and the present state to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> operator_present;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::OperatorPresence from a component.
template <>
class Provided<robots::OperatorPresence> : public ProvidedBase {
  using Contract = robots::OperatorPresence;
  using EventId = robots::OperatorPresenceEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::OperatorPresence.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : operator_present{provided, EventId::operator_present} {}

    /// Reports each change, and the present state to a client that connects.
    Emitter<std::uint8_t, bool> operator_present;
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

  Contract& implementation_;
  Events events_{*this};
};

}  // namespace suture
