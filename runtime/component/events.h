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

/// Subscribes to one event. In the component's constructor, before it is connected; the handler
/// runs in the component's thread, before run().
///   arm_.on().operating_state([this](const OperatingState& state) { ... });
template <class Slot, class... Payload>
class Subscription;

template <>
class Subscription<void> {
 public:
  Subscription(RequiredBase& required, std::uint16_t event) : required_(required), event_(event) {}
  void operator()(std::function<void()> handler);

 private:
  RequiredBase& required_;
  std::uint16_t event_;
};

template <class Slot, class... Payload>
class Subscription {
 public:
  Subscription(RequiredBase& required, std::uint16_t event) : required_(required), event_(event) {}
  void operator()(std::function<void(const Payload&...)> handler) {
    // One object for all events of this kind, so that what it owns is allocated once: here.
    auto scratch = std::make_shared<std::tuple<Payload...>>();
    std::apply([](Payload&... payload) { reserveFor<Slot>(payload...); }, *scratch);
    required_.handlers_[event_] = [handler = std::move(handler),
                                   scratch = std::move(scratch)](const std::byte* memory) {
      const Slot& slot = slotIn<Slot>(memory);
      std::apply(
          [&](Payload&... payload) {
            load(slot, payload...);
            handler(payload...);
          },
          *scratch);
    };
    required_.subscribed_ |= EventSet{1} << event_;
  }

 private:
  RequiredBase& required_;
  std::uint16_t event_;
};

}  // namespace suture
