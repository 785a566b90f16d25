#pragma once
// Waiting for one event.

#include <suture/base/errors.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/base/time.h>
#include <suture/component/required.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace suture {

/// A NextEvent without its payload.
class AwaitedEvent {
 public:
  AwaitedEvent(const AwaitedEvent&) = delete;
  AwaitedEvent& operator=(const AwaitedEvent&) = delete;

 protected:
  /// Armed from now on.
  AwaitedEvent(RequiredBase& required, std::uint16_t event);
  /// Takes the place of `other`, which must not be used any more.
  AwaitedEvent(AwaitedEvent&& other) noexcept;
  ~AwaitedEvent();

  /// True if the event has come or cannot come any more.
  bool over();
  /// Handles what arrives until it is over, at most for `limit`; then that is its end.
  void wait(Duration limit);
  /// Why it has not come; 0: it has.
  Errc error() const { return error_; }

  virtual void take(const std::byte* payload) = 0;

 private:
  friend class RequiredBase;

  void end(Errc error);
  void unlink();

  RequiredBase& required_;
  std::uint16_t event_;
  Time armed_;
  bool over_ = false;
  Errc error_{};
  AwaitedEvent* next_ = nullptr;  // of the same required interface
};

/// The first event of its kind that is emitted after this was made, so that it can be made before
/// the command that leads to the event, and nothing is missed:
///   auto arrived = arm_.on().goal_reached.next();
///   arm_.move_cp(goal);
///   if (const auto where = arrived.within(2s)) ...     Result of the payload, a tuple of several
/// A control loop looks at poll() instead. The answer is Errc::Lost or Faulted if the provider is
/// before the event has come; else it may be NotConnected or WrongThread.
///
/// Belongs to the thread of the component, and must not outlive the required interface. Subscribes
/// to the event, which stays so until reset() of the Subscription; its handler, if any, runs as
/// well. Allocates only if the payload does. The replay of a latched() event is not counted.
/// Errc::CannotWait of an event whose handler is direct().
template <class Slot, class... Payload>
class [[nodiscard]] NextEvent final : private AwaitedEvent {
 public:
  using Value = std::conditional_t<sizeof...(Payload) == 1,
                                   std::tuple_element_t<0, std::tuple<Payload..., int>>,
                                   std::tuple<Payload...>>;
  using Answer = Result<std::conditional_t<sizeof...(Payload) == 0, void, Value>>;

  NextEvent(RequiredBase& required, std::uint16_t event) : AwaitedEvent(required, event) {}
  NextEvent(NextEvent&& other) noexcept = default;

  /// The answer if it is here, else null: looked for where handlers run, before run() or in a
  /// device's processEvents(). Never blocks.
  const Answer* poll() {
    if (!answered_ && over()) answer();
    return answered_ ? &answer_ : nullptr;
  }

  /// The answer, waiting at most `limit` for it, then Errc::Timeout; there is no way to wait
  /// without a limit. The handlers of what else arrives on this interface run meanwhile. Not for a
  /// periodic task, which would miss its period; not in a handler of an event: Errc::CannotWait.
  const Answer& within(Duration limit) {
    if (!answered_) {
      wait(limit);
      answer();
    }
    return answer_;
  }

 private:
  void take(const std::byte* payload) override {
    if constexpr (sizeof...(Payload) != 0) {
      std::apply([&](Payload&... values) { load(slotIn<Slot>(payload), values...); }, payload_);
    }
  }

  void answer() {
    answered_ = true;
    if (error() != Errc{}) {
      answer_ = Answer{tl::unexpect, error()};
    } else if constexpr (sizeof...(Payload) == 0) {
      answer_ = Answer{};
    } else if constexpr (sizeof...(Payload) == 1) {
      answer_ = std::get<0>(std::move(payload_));
    } else {
      answer_ = std::move(payload_);
    }
  }

  std::tuple<Payload...> payload_{};
  Answer answer_{tl::unexpect, Errc::NotYet};
  bool answered_ = false;
};

}  // namespace suture
