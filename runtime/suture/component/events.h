#pragma once
// These are the members of a generated Provided<Contract>::emit() and Required<Contract>::on(): one
// object for each event.

#include <suture/base/slots/loan.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/next_event.h>
#include <suture/component/provided.h>
#include <suture/component/provided/event_loan.h>
#include <suture/component/required.h>

#include <atomic>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

namespace suture {

/// Emits one event. Belongs to the thread of the task that provides the interface: another thread
/// gets Errc::WrongThread, and nothing is emitted. A device may emit in any thread.
///   arm_.emit().operating_state(value);
/// `Slot` is the payload's; with void the event carries nothing.
template <class Slot, class... Payload>
class Emitter;

template <>
class Emitter<void> {
 public:
  Emitter(ProvidedBase& provided, std::uint16_t event)
      : emission_(provided.emission_), event_(event) {}
  /// Never blocks, never allocates. A subscriber whose queue is full loses the event, which is
  /// counted; but it always gets the last value of a latched() event.
  Result<void> operator()();

 private:
  EventEmission& emission_;
  std::uint16_t event_;
};

template <class Slot, class... Payload>
class Emitter {
 public:
  Emitter(ProvidedBase& provided, std::uint16_t event)
      : emission_(provided.emission_), event_(event) {}
  /// Never blocks; never allocates in a task's thread, and in another one only for its first
  /// payload of more than 4 KiB. If the payload exceeds its declared capacity the answer is
  /// Errc::TooLarge, and if the contract does not admit a value of it Errc::Invalid; then no
  /// subscriber gets it. Success does not mean that each one gets it: a subscriber whose queue is
  /// full loses the event, which is counted as events_dropped in the reports of both ends; but it
  /// always gets the last value of a latched() event.
  Result<std::void_t<Slot>> operator()(const Payload&... payload) {  // see resultOf()
    LooseSlot<Slot> slot;
    const bool fits = store(payload..., slot.value());
    return resultOf<std::void_t<Slot>>(emission_.emit(event_, slot.memory(), fits));
  }

  /// Does what operator() does with an event of one value, one list of which `fill` writes; it is
  /// called as that of Command::loan() is. `List` is a member of the payload's slot, or several
  /// that lead to it. If one subscriber hears a queued event of more than 512 bytes, it is written
  /// where it leaves from; otherwise it is copied, as from operator(). `fill` may emit other
  /// events. The event's stamp is when `fill` returns, but who gets it is settled before. So `fill`
  /// should be short: until it returns, further events of this kind find only the room that is left
  /// in the queue. If `fill` throws, nothing is emitted.
  ///   camera_.emit().frame.loan<&FrameSlot::pixels>(frame, [&](std::span<std::uint8_t> room) {
  ///     return sensor_.grab(room);
  ///   });
  template <auto... List, class Fill>
  Result<std::void_t<Slot>> loan(const Payload&... rest, const Fill& fill) {
    static_assert(sizeof...(Payload) == 1, "a loan is for an event with one value");
    return resultOf<std::void_t<Slot>>(emitFilled(
        [&](Slot& slot) { return store(rest..., slot) && fillList(listIn<List...>(slot), fill); }));
  }

 private:
  template <class Store>
  Errc emitFilled(const Store& storeAll) {
    if (emission_.inWrongThread()) return Errc::WrongThread;
    if (EventLoan loan(emission_, event_); loan.memory() != nullptr) {
      return loan.emit(storeAll(*reinterpret_cast<Slot*>(loan.memory())));
    }
    LooseSlot<Slot> slot;
    const bool fits = storeAll(slot.value());
    return emission_.emit(event_, slot.memory(), fits);
  }

  EventEmission& emission_;
  std::uint16_t event_;
};

/// Holds the part of a Subscription that does not depend on what the event carries.
class SubscriptionBase {
 public:
  /// From now on no call of the handler begins, not even for events that wait in the queue; a
  /// direct() one that runs at this moment goes on to its end. A later subscription gets only
  /// events from then on. The handler itself may call this.
  Result<void> reset();

 protected:
  SubscriptionBase(RequiredParts& required, std::uint16_t event)
      : subscriptions_(required.subscriptions), event_(event) {}

  Subscriptions& subscriptions_;
  std::uint16_t event_;
};

/// Subscribes to one event, and ends the subscription. It works in the component's constructor and
/// at any time in its thread; another thread gets Errc::WrongThread. The handler runs in the
/// component's thread, before run() or in a device's processEvents().
///   arm_.on().operating_state([this](const OperatingState& state) { ... });
///   arm_.on().operating_state.reset();
template <class Slot, class... Payload>
class Subscription;

template <>
class Subscription<void> : public SubscriptionBase {
 public:
  Subscription(RequiredParts& required, std::uint16_t event) : SubscriptionBase(required, event) {}
  /// These do what the members of the same names do in Subscription<Slot, Payload...>.
  Result<void> operator()(std::function<void()> handler);
  Result<void> direct(std::function<void()> handler);
  [[nodiscard]] NextEvent<void> next();
};

/// Calls a handler with the values in a slot.
template <class Slot, class... Payload>
class SlotHandler {
 public:
  explicit SlotHandler(std::function<void(const Payload&...)> handler)
      : handler_(std::move(handler)), scratch_(std::make_shared<Scratch>()) {
    std::apply([](Payload&... payload) { reserveFor<Slot>(payload...); }, scratch_->payload);
  }

  void operator()(const std::byte* memory) const {
    if (scratch_->inUse.test_and_set(std::memory_order_acquire)) {  // a device emits in two threads
      std::tuple<Payload...> own;
      return call(memory, own);
    }
    struct Release {
      std::atomic_flag& flag;
      ~Release() { flag.clear(std::memory_order_release); }
    } release{scratch_->inUse};
    call(memory, scratch_->payload);
  }

 private:
  // All events of this kind share one object, so that what it owns is allocated only once.
  struct Scratch {
    std::tuple<Payload...> payload;
    std::atomic_flag inUse = ATOMIC_FLAG_INIT;
  };

  void call(const std::byte* memory, std::tuple<Payload...>& values) const {
    std::apply(
        [&](Payload&... payload) {
          load(slotIn<Slot>(memory), payload...);
          handler_(payload...);
        },
        values);
  }

  std::function<void(const Payload&...)> handler_;
  std::shared_ptr<Scratch> scratch_;
};

/// Returns `handler` in the form that is called with a slot, or null if it is null.
template <class Slot, class... Payload>
std::function<void(const std::byte*)> slotHandler(std::function<void(const Payload&...)> handler) {
  if (handler == nullptr) return nullptr;
  return SlotHandler<Slot, Payload...>(std::move(handler));
}

template <class Slot, class... Payload>
class Subscription : public SubscriptionBase {
 public:
  Subscription(RequiredParts& required, std::uint16_t event) : SubscriptionBase(required, event) {}

  /// Never blocks; allocates only what keeps `handler`, so a control loop should subscribe rarely.
  /// `handler` gets what is emitted once the provider knows of it. A task knows before it executes
  /// any command sent later, on every lane, and emits the last value of a latched() event first. An
  /// earlier handler is replaced.
  Result<std::void_t<Slot>> operator()(std::function<void(const Payload&...)> handler) {
    return resultOf<std::void_t<Slot>>(
        subscriptions_.subscribe(event_, slotHandler<Slot, Payload...>(std::move(handler))));
  }

  /// Subscribes likewise, but if both ends are in one process without a delay between them,
  /// `handler` runs at once in the thread that emits, before emit() returns, even while this
  /// component's own thread runs. So it must be short, safe to call from any thread, and not use
  /// this component's required interfaces (Errc::WrongThread). If it throws, that parks this
  /// component, not the emitter. While this component is suspended or faulted, and from any other
  /// process, the event is queued like any other and `handler` runs in this component's thread.
  Result<std::void_t<Slot>> direct(std::function<void(const Payload&...)> handler) {
    return resultOf<std::void_t<Slot>>(
        subscriptions_.subscribe(event_, slotHandler<Slot, Payload...>(std::move(handler)), true));
  }

  /// Returns a NextEvent, to wait for the next such event or to look for it.
  [[nodiscard]] NextEvent<Slot, Payload...> next() { return {subscriptions_, event_}; }
};

}  // namespace suture
