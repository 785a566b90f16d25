// Written by suturec from 01_counter/counter.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. counter.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "01_counter/counter.h"

namespace counting {

// --- Counter: the arguments of its commands ---

struct CounterAddArguments {
  std::int32_t amount;
};

bool store(const std::int32_t& amount, CounterAddArguments& slot);

/// Numbers the commands of Counter.
struct CounterCommand {
  static constexpr std::uint16_t add = 0;
  static constexpr std::uint16_t value = 1;
};

/// Numbers the events of Counter.
struct CounterEvent {
  static constexpr std::uint16_t ten_more = 0;
};

/// Numbers the reads of Counter as a row of the state has them.
struct CounterColumn {
  static constexpr std::uint16_t value = 0;
};

}  // namespace counting

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<counting::Counter>();

/// Calls counting::Counter of another component.
template <>
class Required<counting::Counter> : public RequiredBase {
  using Contract = counting::Counter;
  using Id = counting::CounterCommand;
  using EventId = counting::CounterEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Adds to the count, in the provider's thread.
  /// Write: up to 8 wait.
  Command<&Contract::add, counting::CounterAddArguments> add{*this, Id::add};
  /// Returns the newest count; never waits for anyone.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::value, std::int64_t> value{*this, Id::value};

  /// Subscribes to the events of counting::Counter.
  struct Events {
    explicit Events(RequiredBase& required)
        : ten_more{required, EventId::ten_more} {}

    /// Reports that the count has passed a multiple of ten.
    /// At a subscriber up to 16 wait.
    Subscription<std::int64_t, std::int64_t> ten_more;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves counting::Counter from a component.
template <>
class Provided<counting::Counter> : public ProvidedBase {
  using Contract = counting::Counter;
  using EventId = counting::CounterEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of counting::Counter.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : ten_more{provided, EventId::ten_more} {}

    /// Reports that the count has passed a multiple of ten.
    Emitter<std::int64_t, std::int64_t> ten_more;
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
    std::int32_t add_amount{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
