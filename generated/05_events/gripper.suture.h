// Written by suturec from 05_events/gripper.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. gripper.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "05_events/gripper.h"

namespace gripping {

bool isKnownJaws(std::uint8_t slot);

/// Numbers the commands of Gripper.
struct GripperCommand {
  static constexpr std::uint16_t grasp = 0;
  static constexpr std::uint16_t release = 1;
};

/// Numbers the events of Gripper.
struct GripperEvent {
  static constexpr std::uint16_t jaws_changed = 0;
  static constexpr std::uint16_t touched = 1;
};

}  // namespace gripping

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<gripping::Gripper>();

/// Calls gripping::Gripper of another component.
template <>
class Required<gripping::Gripper> : public RequiredBase {
  using Contract = gripping::Gripper;
  using Id = gripping::GripperCommand;
  using EventId = gripping::GripperEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Begins to close the jaws.
  /// Void: up to 16 wait.
  Command<&Contract::grasp, NoSlot> grasp{*this, Id::grasp};
  /// Opens the jaws. Returns true if they held something.
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::release, NoSlot, std::uint8_t> release{*this, Id::release};

  /// Subscribes to the events of gripping::Gripper.
  struct Events {
    explicit Events(RequiredBase& required)
        : jaws_changed{required, EventId::jaws_changed},
          touched{required, EventId::touched} {}

    /// Reports a state: a client that subscribes late receives the last one at once.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, gripping::Jaws> jaws_changed;
    /// Reports something that happens. Each touch counts, so up to 16 wait for a busy subscriber.
    /// At a subscriber up to 16 wait.
    Subscription<double, double> touched;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves gripping::Gripper from a component.
template <>
class Provided<gripping::Gripper> : public ProvidedBase {
  using Contract = gripping::Gripper;
  using EventId = gripping::GripperEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of gripping::Gripper.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : jaws_changed{provided, EventId::jaws_changed},
          touched{provided, EventId::touched} {}

    /// Reports a state: a client that subscribes late receives the last one at once.
    Emitter<std::uint8_t, gripping::Jaws> jaws_changed;
    /// Reports something that happens. Each touch counts, so up to 16 wait for a busy subscriber.
    Emitter<double, double> touched;
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
