// Written by suturec from suture/standard/lifecycle.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. lifecycle.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "suture/standard/lifecycle.h"

namespace suture {

/// Says that a component has come into a state.
struct StateChangeSlot {
  std::uint8_t state;  // ComponentState
  suture::BoundedText<255> fault;
  std::int64_t stamp;  // suture::Time, ns
};

bool store(const StateChange& value, StateChangeSlot& slot);
void load(const StateChangeSlot& slot, StateChange& value);
void reserve(const StateChangeSlot*, StateChange& value);
void shiftStamps(StateChangeSlot& slot, suture::Duration shift);

bool isKnownComponentState(std::uint8_t slot);
bool isKnownResumeOutcome(std::uint8_t slot);
bool isValid(const StateChangeSlot& slot, suture::FieldPath* path);

// --- Lifecycle: the arguments of its commands ---

struct LifecycleResumeConnectionArguments {
  suture::BoundedText<63> required;
};

bool store(const std::string& required, LifecycleResumeConnectionArguments& slot);

/// Numbers the commands of Lifecycle.
struct LifecycleCommand {
  static constexpr std::uint16_t suspend = 0;
  static constexpr std::uint16_t resume = 1;
  static constexpr std::uint16_t component_state = 2;
  static constexpr std::uint16_t resume_connection = 3;
};

/// Numbers the events of Lifecycle.
struct LifecycleEvent {
  static constexpr std::uint16_t state_changed = 0;
};

/// Numbers the reads of Lifecycle as a row of the state has them.
struct LifecycleColumn {
  static constexpr std::uint16_t component_state = 0;
};

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::StateChange& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::StateChange& value);

template <>
const InterfaceInfo& interfaceInfo<suture::Lifecycle>();

/// Calls suture::Lifecycle of another component.
template <>
class Required<suture::Lifecycle> : public RequiredBase {
  using Contract = suture::Lifecycle;
  using Id = suture::LifecycleCommand;
  using EventId = suture::LifecycleEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Suspends the component, which does nothing from its next cycle on. Returns false if it is not
  /// running.
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::suspend, NoSlot, std::uint8_t> suspend{*this, Id::suspend};
  /// Lets the component go on. Returns false if it is not suspended.
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::resume, NoSlot, std::uint8_t> resume{*this, Id::resume};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::component_state, std::uint8_t> component_state{*this, Id::component_state};
  /// Lets the commands of a required interface through again, which await their operator after a
  /// loss or a value that was too old.
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::resume_connection, suture::LifecycleResumeConnectionArguments,
                   std::uint8_t> resume_connection{*this, Id::resume_connection};

  /// Subscribes to the events of suture::Lifecycle.
  struct Events {
    explicit Events(RequiredBase& required)
        : state_changed{required, EventId::state_changed} {}

    /// Reports each transition once, and the last one to a client that subscribes later.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<StateChangeSlot, StateChange> state_changed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves suture::Lifecycle from a component.
template <>
class Provided<suture::Lifecycle> : public ProvidedBase {
  using Contract = suture::Lifecycle;
  using EventId = suture::LifecycleEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of suture::Lifecycle.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : state_changed{provided, EventId::state_changed} {}

    /// Reports each transition once, and the last one to a client that subscribes later.
    Emitter<StateChangeSlot, StateChange> state_changed;
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

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    std::string resume_connection_required{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
