// Written by suturec from reference/gripper_arm.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. gripper_arm.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "reference/gripper_arm.h"
#include "reference/arm_like.suture.h"
#include "reference/arm_types.suture.h"

namespace reference {

// --- GripperArm: the arguments of its commands ---

struct GripperArmCloseArguments {
  double width;  // m
};

bool store(const double& width, GripperArmCloseArguments& slot);

struct GripperArmFitsArguments {
  double width;  // m
};

bool store(const double& width, GripperArmFitsArguments& slot);

/// Numbers the commands of GripperArm, behind those that it inherits.
struct GripperArmCommand {
  static constexpr std::uint16_t close = 11;
  static constexpr std::uint16_t opening = 12;
  static constexpr std::uint16_t release = 13;
  static constexpr std::uint16_t fits = 14;
};

/// Numbers the events of GripperArm, behind those that it inherits.
struct GripperArmEvent {
  static constexpr std::uint16_t gripped = 4;
};

/// Numbers the reads of GripperArm as a row of the state has them.
struct GripperArmColumn {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t measured_js = 1;
  static constexpr std::uint16_t opening = 2;
};

}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::GripperArm>();

/// Calls reference::GripperArm of another component.
template <>
class Required<reference::GripperArm> : public Required<reference::ArmLike> {
  using Contract = reference::GripperArm;
  using Id = reference::GripperArmCommand;
  using EventId = reference::GripperArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Closes to this width; answers the width that it could reach.
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer. `width` is in m.
  ReturningCommand<&Contract::close, reference::GripperArmCloseArguments, double> close{
      *this, Id::close};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::opening, double> opening{*this, Id::opening};
  /// Lets go at once.
  /// Void: up to 16 wait. Touches atomics only.
  Command<&Contract::release, NoSlot> release{*this, Id::release};
  /// Qualified read: may run while the component runs. `within()` waits 1 s for the answer. `width`
  /// is in m.
  QualifiedReadCommand<&Contract::fits, reference::GripperArmFitsArguments, std::uint8_t> fits{
      *this, Id::fits};

  /// Subscribes to the events of reference::GripperArm.
  struct Events : Required<reference::ArmLike>::Events {
    explicit Events(RequiredBase& required)
        : Required<reference::ArmLike>::Events(required),
          gripped{required, EventId::gripped} {}

    /// At a subscriber up to 16 wait.
    Subscription<double, double> gripped;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<reference::ArmLike>(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves reference::GripperArm from a component.
template <>
class Provided<reference::GripperArm> : public Provided<reference::ArmLike> {
  using Contract = reference::GripperArm;
  using EventId = reference::GripperArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of reference::GripperArm.
  struct Events : Provided<reference::ArmLike>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<reference::ArmLike>::Events(provided),
          gripped{provided, EventId::gripped} {}

    Emitter<double, double> gripped;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : Provided<reference::ArmLike>(owner, name, info, whole, implementation),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    double close_width{};
    double fits_width{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
