// Written by suturec from arm/gripper.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. gripper.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "arm/gripper.h"
#include "robot_types/joint_commands.suture.h"
#include "robot_types/joints.suture.h"

namespace robots {

/// Numbers the commands of Gripper.
struct GripperCommand {
  static constexpr std::uint16_t configuration_js = 0;
  static constexpr std::uint16_t measured_js = 1;
};

/// Numbers the events of Gripper.
struct GripperEvent {
  static constexpr std::uint16_t closed = 0;
};

/// Numbers the reads of Gripper as a row of the state has them.
struct GripperColumn {
  static constexpr std::uint16_t configuration_js = 0;
  static constexpr std::uint16_t measured_js = 1;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>();

/// Calls robots::Gripper of another component.
template <>
class Required<robots::Gripper> : public RequiredBase {
  using Contract = robots::Gripper;
  using Id = robots::GripperCommand;
  using EventId = robots::GripperEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Says what the joint is and what it may do.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::configuration_js, robots::JointConfigurationSlot> configuration_js{
      *this, Id::configuration_js};
  /// Says where the joint is. The stamp is that of the drives' cycle that measured it. Before the
  /// first such cycle the value is not valid.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_js, robots::JointStateSlot> measured_js{*this, Id::measured_js};

  /// Subscribes to the events of robots::Gripper.
  struct Events {
    explicit Events(RequiredBase& required)
        : closed{required, EventId::closed} {}

    /// Reports if the gripper is closed, each time that this changes, and the last one to a client
    /// that connects: dVRK's gripper/closed.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> closed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Gripper from a component.
template <>
class Provided<robots::Gripper> : public ProvidedBase {
  using Contract = robots::Gripper;
  using EventId = robots::GripperEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Gripper.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : closed{provided, EventId::closed} {}

    /// Reports if the gripper is closed, each time that this changes, and the last one to a client
    /// that connects: dVRK's gripper/closed.
    Emitter<std::uint8_t, bool> closed;
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
