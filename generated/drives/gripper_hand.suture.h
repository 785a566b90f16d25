// Written by suturec from drives/gripper_hand.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. gripper_hand.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "drives/gripper_hand.h"

namespace robots {

// --- GripperHand: the arguments of its commands ---

struct GripperHandSqueezeArguments {
  double angle;  // rad
};

bool store(const double& angle, GripperHandSqueezeArguments& slot);

/// Numbers the commands of GripperHand.
struct GripperHandCommand {
  static constexpr std::uint16_t squeeze = 0;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::GripperHand>();

/// Calls robots::GripperHand of another component.
template <>
class Required<robots::GripperHand> : public RequiredBase {
  using Contract = robots::GripperHand;
  using Id = robots::GripperHandCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Makes the fingers press the handles to this angle, newest wins. It stays there until another
  /// one comes. The gripper follows with the lag of the drives, and no further than its stops.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 100 ms
  /// ago. `angle` is in rad.
  Command<&Contract::squeeze, robots::GripperHandSqueezeArguments> squeeze{*this, Id::squeeze};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::GripperHand from a component.
template <>
class Provided<robots::GripperHand> : public ProvidedBase {
  using Contract = robots::GripperHand;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

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
    double squeeze_angle{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
