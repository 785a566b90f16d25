// Written by suturec from 04_contract_and_loss/joystick.h. Do not edit.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "04_contract_and_loss/joystick.h"

namespace following {

/// Names the numbers of Joystick's commands in every table and record.
enum class JoystickCommand : std::uint16_t {
  angle,
};

/// Names where a row of the state has each read of Joystick.
enum class JoystickColumn : std::uint16_t {
  angle,
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
  ReadCommand<&Contract::angle, double> angle{*this, static_cast<std::uint16_t>(Id::angle)};

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
