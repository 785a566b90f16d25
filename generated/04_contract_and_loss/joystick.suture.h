// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. joystick.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "04_contract_and_loss/joystick.h"

namespace following {

/// Numbers the commands of Joystick.
struct JoystickCommand {
  static constexpr std::uint16_t angle = 0;
};

/// Numbers the reads of Joystick as a row of the state has them.
struct JoystickColumn {
  static constexpr std::uint16_t angle = 0;
};

}  // namespace following

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<following::Joystick>();

/// Calls following::Joystick of another component.
template <>
class Required<following::Joystick> : public RequiredBase {
  using Contract = following::Joystick;
  using Id = following::JoystickCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Says how far the stick is turned.
  /// Read: answered at once with what the last cycle left. The answer is in rad.
  ReadCommand<&Contract::angle, double> angle{*this, Id::angle};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves following::Joystick from a component.
template <>
class Provided<following::Joystick> : public ProvidedBase {
  using Contract = following::Joystick;

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

  Contract& implementation_;
};

}  // namespace suture
