// Written by suturec from pedals/foot_pedals.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. foot_pedals.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "pedals/foot_pedals.h"

namespace robots {

/// Says what the feet do. It counts only as long as it is fresh: a client that does not receive it
/// any more must assume that all pedals are pressed.
struct PedalStateSlot {
  std::uint8_t clutch;       // bool
  std::uint8_t camera;       // bool
  std::uint8_t coagulation;  // bool
  std::int64_t stamp;        // suture::Time, ns
};

bool store(const PedalState& value, PedalStateSlot& slot);
void load(const PedalStateSlot& slot, PedalState& value);
void shiftStamps(PedalStateSlot& slot, suture::Duration shift);

bool isValid(const PedalStateSlot& slot, suture::FieldPath* path);

/// Numbers the commands of FootPedals.
struct FootPedalsCommand {
  static constexpr std::uint16_t pedals = 0;
};

/// Numbers the events of FootPedals.
struct FootPedalsEvent {
  static constexpr std::uint16_t clutch = 0;
  static constexpr std::uint16_t camera = 1;
  static constexpr std::uint16_t coagulation = 2;
};

/// Numbers the reads of FootPedals as a row of the state has them.
struct FootPedalsColumn {
  static constexpr std::uint16_t pedals = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PedalState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::PedalState& value);

template <>
const InterfaceInfo& interfaceInfo<robots::FootPedals>();

/// Calls robots::FootPedals of another component.
template <>
class Required<robots::FootPedals> : public RequiredBase {
  using Contract = robots::FootPedals;
  using Id = robots::FootPedalsCommand;
  using EventId = robots::FootPedalsEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::pedals, robots::PedalStateSlot> pedals{*this, Id::pedals};

  /// Subscribes to the events of robots::FootPedals.
  struct Events {
    explicit Events(RequiredBase& required)
        : clutch{required, EventId::clutch},
          camera{required, EventId::camera},
          coagulation{required, EventId::coagulation} {}

    /// Reports each press and release, and the present state to a client that connects.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> clutch;
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> camera;
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<std::uint8_t, bool> coagulation;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves robots::FootPedals from a component.
template <>
class Provided<robots::FootPedals> : public ProvidedBase {
  using Contract = robots::FootPedals;
  using EventId = robots::FootPedalsEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::FootPedals.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : clutch{provided, EventId::clutch},
          camera{provided, EventId::camera},
          coagulation{provided, EventId::coagulation} {}

    /// Reports each press and release, and the present state to a client that connects.
    Emitter<std::uint8_t, bool> clutch;
    Emitter<std::uint8_t, bool> camera;
    Emitter<std::uint8_t, bool> coagulation;
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
