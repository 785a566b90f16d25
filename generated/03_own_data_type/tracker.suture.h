// Written by suturec from 03_own_data_type/tracker.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. tracker.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "03_own_data_type/tracker.h"
#include "03_own_data_type/observation.suture.h"

namespace tracking {

/// Numbers the commands of Tracker.
struct TrackerCommand {
  static constexpr std::uint16_t observation = 0;
};

/// Numbers the reads of Tracker as a row of the state has them.
struct TrackerColumn {
  static constexpr std::uint16_t observation = 0;
};

}  // namespace tracking

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<tracking::Tracker>();

/// Calls tracking::Tracker of another component.
template <>
class Required<tracking::Tracker> : public RequiredBase {
  using Contract = tracking::Tracker;
  using Id = tracking::TrackerCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns the newest observation; never waits for anyone.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::observation, tracking::ObservationSlot> observation{
      *this, Id::observation};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves tracking::Tracker from a component.
template <>
class Provided<tracking::Tracker> : public ProvidedBase {
  using Contract = tracking::Tracker;

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
