// Written by suturec from robots/gripper.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. gripper.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "robots/gripper.h"
#include "robots/arm.suture.h"
#include "robots/geometry.suture.h"

namespace robots {

// --- Gripper: the arguments of its commands ---

struct GripperOpenArguments {
  double width;  // m
};

bool store(const double& width, GripperOpenArguments& slot);

struct GripperFitsArguments {
  double width;
};

bool store(const double& width, GripperFitsArguments& slot);

// --- Gripper: what its events carry ---

struct GripperGrippedPayload {
  double value;
  std::uint8_t value2;
};

bool store(const double& value, const bool& value2, GripperGrippedPayload& slot);
void load(const GripperGrippedPayload& slot, double& value, bool& value2);

/// Numbers the commands of Gripper, behind those that it inherits.
struct GripperCommand {
  static constexpr std::uint16_t open = 11;
  static constexpr std::uint16_t opening = 12;
  static constexpr std::uint16_t fits = 13;
};

/// Numbers the events of Gripper, behind those that it inherits.
struct GripperEvent {
  static constexpr std::uint16_t gripped = 4;
};

/// Numbers the reads of Gripper as a row of the state has them.
struct GripperColumn {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t mode = 1;
  static constexpr std::uint16_t everything = 2;
  static constexpr std::uint16_t load = 3;
  static constexpr std::uint16_t opening = 4;
};

// --- Names: the arguments of its commands ---

struct NamesQueueArguments {
  std::int32_t name;
};

bool store(const std::int32_t& name, NamesQueueArguments& slot);

struct NamesNameArguments {
  double range;
  double slot;
  double store;
};

bool store(const double& range, const double& slot, const double& storeGiven,
           NamesNameArguments& slotGiven);

/// Numbers the commands of Names.
struct NamesCommand {
  static constexpr std::uint16_t queue = 0;
  static constexpr std::uint16_t name = 1;
  static constexpr std::uint16_t range = 2;
};

/// Numbers the events of Names.
struct NamesEvent {
  static constexpr std::uint16_t latched = 0;
};

/// Numbers the reads of Names as a row of the state has them.
struct NamesColumn {
  static constexpr std::uint16_t range = 0;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>();

/// Calls robots::Gripper of another component.
template <>
class Required<robots::Gripper> : public Required<robots::Arm> {
  using Contract = robots::Gripper;
  using Id = robots::GripperCommand;
  using EventId = robots::GripperEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait. `width` is in m.
  Command<&Contract::open, robots::GripperOpenArguments> open{*this, Id::open};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::opening, double> opening{*this, Id::opening};
  /// Qualified read: may run while the component runs. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::fits, robots::GripperFitsArguments, std::uint8_t> fits{
      *this, Id::fits};

  /// Subscribes to the events of robots::Gripper.
  struct Events : Required<robots::Arm>::Events {
    explicit Events(RequiredBase& required)
        : Required<robots::Arm>::Events(required),
          gripped{required, EventId::gripped} {}

    /// At a subscriber up to 16 wait.
    Subscription<robots::GripperGrippedPayload, double, bool> gripped;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<robots::Arm>(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Gripper from a component.
template <>
class Provided<robots::Gripper> : public Provided<robots::Arm> {
  using Contract = robots::Gripper;
  using EventId = robots::GripperEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Gripper.
  struct Events : Provided<robots::Arm>::Events {
    explicit Events(ProvidedBase& provided)
        : Provided<robots::Arm>::Events(provided),
          gripped{provided, EventId::gripped} {}

    Emitter<robots::GripperGrippedPayload, double, bool> gripped;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : Provided<robots::Arm>(owner, name, info, whole, implementation),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    double open_width{};
    double fits_width{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

template <>
const InterfaceInfo& interfaceInfo<robots::Names>();

/// Calls robots::Names of another component.
template <>
class Required<robots::Names> : public RequiredBase {
  using Contract = robots::Names;
  using Id = robots::NamesCommand;
  using EventId = robots::NamesEvent;

 public:
  Required(Component& owner, std::string_view nameGiven)
      : Required(owner, nameGiven, interfaceInfo<Contract>()) {}

  /// Write: up to 4 wait.
  Command<&Contract::queue, robots::NamesQueueArguments> queue{*this, Id::queue};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::name, robots::NamesNameArguments, std::uint8_t> name{*this, Id::name};
  /// Read: answered at once with what the last cycle left. The answer is from 0 to 1.
  ReadCommand<&Contract::range, double> range{*this, Id::range};

  /// Subscribes to the events of robots::Names.
  struct Events {
    explicit Events(RequiredBase& required)
        : latched{required, EventId::latched} {}

    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<double, double> latched;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view nameGiven, const InterfaceInfo& info)
      : RequiredBase(owner, nameGiven, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::Names from a component.
template <>
class Provided<robots::Names> : public ProvidedBase {
  using Contract = robots::Names;
  using EventId = robots::NamesEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Names.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : latched{provided, EventId::latched} {}

    Emitter<double, double> latched;
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

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    std::int32_t queue_name{};
    double name_range{};
    double name_slot{};
    double name_store{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
