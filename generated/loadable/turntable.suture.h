// Written by suturec from loadable/turntable.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. turntable.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "loadable/turntable.h"

namespace loadable {

// --- Turntable: the arguments of its commands ---

struct TurntableTurnArguments {
  double angle;  // rad
};

bool store(const double& angle, TurntableTurnArguments& slot);

/// Numbers the commands of Turntable.
struct TurntableCommand {
  static constexpr std::uint16_t turn = 0;
  static constexpr std::uint16_t angle = 1;
};

/// Numbers the reads of Turntable as a row of the state has them.
struct TurntableColumn {
  static constexpr std::uint16_t angle = 0;
};

}  // namespace loadable

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<loadable::Turntable>();

/// Calls loadable::Turntable of another component.
template <>
class Required<loadable::Turntable> : public RequiredBase {
  using Contract = loadable::Turntable;
  using Id = loadable::TurntableCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait. `angle` is in rad.
  Command<&Contract::turn, loadable::TurntableTurnArguments> turn{*this, Id::turn};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::angle, double> angle{*this, Id::angle};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves loadable::Turntable from a component.
template <>
class Provided<loadable::Turntable> : public ProvidedBase {
  using Contract = loadable::Turntable;

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
    double turn_angle{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
