// Written by suturec from unit/frame/latch.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. latch.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/frame/latch.h"

namespace latches {

/// Numbers the commands of Latch.
struct LatchCommand {
  static constexpr std::uint16_t close = 0;
};

/// Numbers the events of Latch.
struct LatchEvent {
  static constexpr std::uint16_t closed = 0;
};

}  // namespace latches

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<latches::Latch>();

/// Calls latches::Latch of another component.
template <>
class Required<latches::Latch> : public RequiredBase {
  using Contract = latches::Latch;
  using Id = latches::LatchCommand;
  using EventId = latches::LatchEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Void: up to 16 wait.
  Command<&Contract::close, NoSlot> close{*this, Id::close};

  /// Subscribes to the events of latches::Latch.
  struct Events {
    explicit Events(RequiredBase& required)
        : closed{required, EventId::closed} {}

    /// At a subscriber up to 16 wait.
    Subscription<void> closed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves latches::Latch from a component.
template <>
class Provided<latches::Latch> : public ProvidedBase {
  using Contract = latches::Latch;
  using EventId = latches::LatchEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of latches::Latch.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : closed{provided, EventId::closed} {}

    Emitter<void> closed;
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
