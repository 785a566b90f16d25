// Written by suturec from reference/gripper_arm.h. Do not edit.
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

/// Names the numbers of GripperArm's own commands in every table and record.
enum class GripperArmCommand : std::uint16_t {
  close = 11,
  opening,
  release,
  fits,
};

/// Names the numbers of GripperArm's own events.
enum class GripperArmEvent : std::uint16_t {
  gripped = 4,
};

/// Names where a row of the state has each read of GripperArm.
enum class GripperArmColumn : std::uint16_t {
  measured_cp,
  measured_js,
  opening,
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
  ReturningCommand<&Contract::close, reference::GripperArmCloseArguments, double> close{
      *this, static_cast<std::uint16_t>(Id::close)};
  ReadCommand<&Contract::opening, double> opening{*this, static_cast<std::uint16_t>(Id::opening)};
  /// Lets go at once.
  Command<&Contract::release, NoSlot> release{*this, static_cast<std::uint16_t>(Id::release)};
  QualifiedReadCommand<&Contract::fits, reference::GripperArmFitsArguments, std::uint8_t> fits{
      *this, static_cast<std::uint16_t>(Id::fits)};

  /// Subscribes to the events of reference::GripperArm.
  struct Events : Required<reference::ArmLike>::Events {
    explicit Events(RequiredBase& required)
        : Required<reference::ArmLike>::Events(required),
          gripped{required, static_cast<std::uint16_t>(EventId::gripped)} {}

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
          gripped{provided, static_cast<std::uint16_t>(EventId::gripped)} {}

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
