#pragma once
// This waits for one event.

#include <suture/base/errors.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/base/time.h>
#include <suture/component/required/subscriptions.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace suture {

/// Catches the first event of its kind that is emitted after this was made. Make it before the
/// command that leads to the event, so that none is missed:
///   auto arrived = arm_.on().goal_reached.next();
///   arm_.move_cp(goal);
///   if (const auto where = arrived.within(2s)) ...     Result of the payload, a tuple of several
/// A control loop looks at poll() instead. The answer is Errc::Lost or Faulted if the provider gets
/// lost or faulted before the event has come; else it may be NotConnected or WrongThread.
///
/// Belongs to the thread of the component, and must not outlive the required interface. Subscribes
/// to the event, until reset() of the Subscription; a handler of it runs as well. Allocates only if
/// the payload does. Ignores the replay of a latched() event. Answers Errc::CannotWait for an event
/// whose handler is direct().
template <class Slot, class... Payload>
class [[nodiscard]] NextEvent final : private AwaitedEvent {
 public:
  using Value = std::conditional_t<sizeof...(Payload) == 1,
                                   std::tuple_element_t<0, std::tuple<Payload..., int>>,
                                   std::tuple<Payload...>>;
  using Answer = Result<std::conditional_t<sizeof...(Payload) == 0, void, Value>>;

  NextEvent(Subscriptions& subscriptions, std::uint16_t event)
      : AwaitedEvent(subscriptions, event) {}
  NextEvent(NextEvent&& other) noexcept = default;

  /// Never blocks. Returns the answer if it is here, else null. It looks for one where handlers
  /// run, before run() or in a device's processEvents().
  const Answer* poll() & {
    if (!answered_ && over()) answer();
    return answered_ ? &answer_ : nullptr;
  }
  const Answer* poll() && = delete;

  /// Waits at most `limit` for the answer and returns it, or Errc::Timeout; there is no way to wait
  /// without a limit. Meanwhile it runs the handlers of what else arrives on this interface. It is
  /// not for a periodic task, which would miss its period. In a handler of an event it answers
  /// Errc::CannotWait.
  const Answer& within(Duration limit) & {
    if (!answered_) {
      wait(limit);
      answer();
    }
    return answer_;
  }
  /// Does the same for an object that nobody keeps.
  Answer within(Duration limit) && {
    within(limit);
    return std::move(answer_);
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
