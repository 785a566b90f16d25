// Written by suturec from unit/contracts/lamp.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. lamp.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/contracts/lamp.h"
#include "suture/standard/messages.suture.h"

namespace contracts {

// --- Lamp: the arguments of its commands ---

struct LampLightArguments {
  std::uint8_t on;
};

bool store(const bool& on, LampLightArguments& slot);

/// Numbers the commands of Lamp.
struct LampCommand {
  static constexpr std::uint16_t light = 0;
  static constexpr std::uint16_t lit = 1;
};

/// Numbers the reads of Lamp as a row of the state has them.
struct LampColumn {
  static constexpr std::uint16_t lit = 0;
};

}  // namespace contracts

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<contracts::Lamp>();

/// Calls contracts::Lamp of another component.
template <>
class Required<contracts::Lamp> : public Required<suture::Messages> {
  using Contract = contracts::Lamp;
  using Id = contracts::LampCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::light, contracts::LampLightArguments> light{*this, Id::light};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::lit, std::uint8_t> lit{*this, Id::lit};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<suture::Messages>(owner, name, info) {}
};

/// Serves contracts::Lamp from a component.
template <>
class Provided<contracts::Lamp> : public Provided<suture::Messages> {
  using Contract = contracts::Lamp;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : Provided<suture::Messages>(owner, name, info, whole, implementation),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    bool light_on{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
