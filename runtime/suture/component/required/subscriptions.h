#pragma once
// A required interface hears events by these.

#include <suture/base/errors.h>
#include <suture/component/required/attachment.h>
#include <suture/component/required/awaited_events.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace suture {

/// Belongs to the thread of the component, but for what says otherwise.
class Subscriptions final : private Attachment::User {
 public:
  /// Gets the slot of what the event carries.
  using Handler = std::function<void(const std::byte*)>;

  explicit Subscriptions(Attachment& attachment);
  Subscriptions(const Subscriptions&) = delete;
  Subscriptions& operator=(const Subscriptions&) = delete;

  /// The events that are subscribed to. Any thread.
  EventSet subscribed() const { return subscribed_.load(std::memory_order_relaxed); }
  /// Errc::WrongThread if the interface is another thread's. `direct`: where both ends are in one
  /// process, the thread that emits runs the handler.
  Errc subscribe(std::uint16_t event, Handler handler, bool direct = false);
  Errc unsubscribe(std::uint16_t event);

  /// Runs the handlers of the events that have arrived, and returns how many.
  std::size_t handleQueued();
  /// True if there are any.
  bool pending() const;

  /// Subscribes to `event`, so that it can be awaited; an error says why it cannot.
  Errc await(std::uint16_t event);
  AwaitedEvents& awaited() { return awaited_; }
  /// Handles what arrives until `event` is over, at most for `limit`. Answers why it may not be:
  /// Errc::Timeout; WrongThread or CannotWait, at once.
  Errc waitFor(AwaitedEvent& event, Duration limit);
  /// Why no event will come any more; 0: one may.
  Errc end() const;
  /// True if such a wait has handled an event since offerNews() that it was not for.
  bool unseen() const { return handledInWait_; }
  /// Leaves the effects of those to run().
  void offerNews() { handledInWait_ = false; }

 private:
  struct Heard {
    std::shared_ptr<const Handler> handler;
    Time since{};  // when it got a handler, after having had none
    bool direct = false;
  };

  void leave() override { awaited_.endAll(Errc::Lost); }
  void join() override;

  /// Tells the provider's end what is subscribed to by now.
  void passOn(EventSet joining);
  /// Has the provider run the handler of `event` itself, if that is direct and both are here.
  void lendHandler(std::uint16_t event);
  void deliver(const rt::EventRecord& record);
  std::size_t handleArrivals();

  Attachment& attachment_;
  std::vector<Heard> heard_;             // by event
  std::atomic<EventSet> subscribed_{0};  // the owner's; read by who connects
  AwaitedEvents awaited_;
  bool handling_ = false;       // a handler of an event is running
  bool handledInWait_ = false;  // events, other than the one waited for
};

}  // namespace suture
