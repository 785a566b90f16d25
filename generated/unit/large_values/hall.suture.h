// Written by suturec from unit/large_values/hall.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. hall.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/large_values/hall.h"
#include "unit/large_values/picture.suture.h"

namespace large_values {

// --- Hall: the arguments of its commands ---

struct HallFillArguments {
  PictureSlot picture;
};

bool store(const Picture& picture, HallFillArguments& slot);

/// Numbers the commands of Hall.
struct HallCommand {
  static constexpr std::uint16_t fill = 0;
};

}  // namespace large_values

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<large_values::Hall>();

/// Calls large_values::Hall of another component.
template <>
class Required<large_values::Hall> : public RequiredBase {
  using Contract = large_values::Hall;
  using Id = large_values::HallCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 2000 wait.
  Command<&Contract::fill, large_values::HallFillArguments> fill{*this, Id::fill};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves large_values::Hall from a component.
template <>
class Provided<large_values::Hall> : public ProvidedBase {
  using Contract = large_values::Hall;

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

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    large_values::Picture fill_picture{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
