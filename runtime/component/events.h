#pragma once
// The members of a generated Provided<Contract>::emit() and Required<Contract>::on(): one object an
// event.

#include <suture/base/shared_slot.h>
#include <suture/base/slot_forms.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <functional>
#include <memory>
#include <tuple>

namespace suture {

/// Emits one event. Belongs to the provider's thread; of a device, to any.
///   arm_.emit().operating_state(value);
/// `Slot` is the payload's; void: the event carries nothing.
template <class Slot, class... Payload>
class Emitter;

template <>
class Emitter<void> {
 public:
  Emitter(ProvidedBase& provided, std::uint16_t event) : provided_(provided), event_(event) {}
  /// Never blocks, never allocates; a subscriber whose queue is full loses it, and that is counted.
  void operator()() { provided_.emit(event_, {}); }

 private:
  ProvidedBase& provided_;
  std::uint16_t event_;
};

template <class Slot, class... Payload>
class Emitter {
 public:
  Emitter(ProvidedBase& provided, std::uint16_t event) : provided_(provided), event_(event) {}
  /// Never blocks, never allocates. Errc::TooLarge if the payload exceeds its declared capacity;
  /// nobody gets it then.
  Result<void> operator()(const Payload&... payload) {
    LooseSlot<Slot> slot;
    if (!store(payload..., slot.value())) return tl::unexpected(Errc::TooLarge);
    provided_.emit(event_, slot.bytes());
    return {};
  }

 private:
  ProvidedBase& provided_;
  std::uint16_t event_;
};

/// One event, to subscribe to and to leave again. In the component's constructor, or later in its
/// thread at any time; another thread gets Errc::WrongThread. The handler runs in the component's
/// thread, before run() or in a device's processEvents().
///   arm_.on().operating_state([this](const OperatingState& state) { ... });
///   arm_.on().operating_state.reset();
template <class Slot, class... Payload>
class Subscription;

template <>
class Subscription<void> {
 public:
  Subscription(RequiredBase& required, std::uint16_t event) : required_(required), event_(event) {}
  /// See the other Subscription.
  Result<void> operator()(std::function<void()> handler);
  Result<void> reset() { return required_.unsubscribe(event_); }

 private:
  RequiredBase& required_;
  std::uint16_t event_;
};

template <class Slot, class... Payload>
class Subscription {
 public:
  Subscription(RequiredBase& required, std::uint16_t event) : required_(required), event_(event) {}

  /// From now on `handler` gets what is emitted once the provider knows: a task does before it
  /// executes any command sent later, on every lane, and begins with the last value of a latched()
  /// event. An earlier handler is replaced. Never blocks; what it allocates is what keeps
  /// `handler`, so a control loop subscribes rarely.
  Result<void> operator()(std::function<void(const Payload&...)> handler) {
    if (handler == nullptr) return reset();
    // One object for all events of this kind, so that what it owns is allocated once.
    return required_.subscribe(
        event_, [handler = std::move(handler),
                 scratch = std::make_shared<std::tuple<Payload...>>()](const std::byte* memory) {
          const Slot& slot = slotIn<Slot>(memory);
          std::apply(
              [&](Payload&... payload) {
                load(slot, payload...);
                handler(payload...);
              },
              *scratch);
        });
  }

  /// No handler runs any more, not even for events that wait in the queue: whoever subscribes anew
  /// gets only what comes after. May be called by the handler itself.
  Result<void> reset() { return required_.unsubscribe(event_); }

 private:
  RequiredBase& required_;
  std::uint16_t event_;
};

}  // namespace suture
