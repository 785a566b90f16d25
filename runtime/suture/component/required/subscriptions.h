#pragma once
// A required interface receives events by these.

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

/// Belongs to the thread of the component, except where a comment says otherwise.
class Subscriptions final : private Attachment::User {
 public:
  /// Gets the slot of what the event carries.
  using Handler = std::function<void(const std::byte*)>;

  explicit Subscriptions(Attachment& attachment);
  Subscriptions(const Subscriptions&) = delete;
  Subscriptions& operator=(const Subscriptions&) = delete;

  /// Any thread. Returns the events that are subscribed to.
  EventSet subscribed() const { return subscribed_.load(std::memory_order_relaxed); }
  /// Answers Errc::WrongThread if the interface is another thread's. If `direct` and both ends are
  /// in one process, the thread that emits runs the handler.
  Errc subscribe(std::uint16_t event, Handler handler, bool direct = false);
  Errc unsubscribe(std::uint16_t event);

  /// Runs the handlers of the events that have arrived, and returns how many.
  std::size_t handleQueued();
  /// Returns true if there are any.
  bool pending() const;
  /// Returns true in a handler of an event, while no other may be handled.
  bool handling() const { return handling_; }

  /// Subscribes to `event`, so that it can be awaited; an error says why it cannot.
  Errc await(std::uint16_t event);
  AwaitedEvents& awaited() { return awaited_; }
  /// Handles what arrives until `event` is over, at most for `limit`. Answers Errc::Timeout if it
  /// is not over by then, Cancelled if its component stops, and WrongThread or CannotWait at once.
  Errc waitFor(AwaitedEvent& event, Duration limit);
  /// Returns why no event will come any more, or 0 if one may.
  Errc end() const;
  /// Returns true if such a wait has handled an event since markSeen() that it did not wait for.
  bool unseen() const { return handledInWait_; }
  /// Notes that the run() which follows sees the effects of those.
  void markSeen() { handledInWait_ = false; }

 private:
  struct Heard {
    std::shared_ptr<const Handler> handler;
    Time since{};  // when it got a handler, after having had none
    bool direct = false;
  };

  void leave() override { awaited_.endAll(Errc::Lost); }
  void join() override;

  /// Keeps what waits of `event` from the handler that it gets now.
  void begin(std::uint16_t event);
  /// Tells the provider's end what is subscribed to.
  void passOn(EventSet joining);
  /// Lets the provider run the handler of `event` itself, if it is direct and both are here.
  void lendHandler(std::uint16_t event);
  void deliver(const rt::EventRecord& record);
  std::size_t handleArrivals();

  Attachment& attachment_;
  std::vector<Heard> heard_;             // by event
  std::atomic<EventSet> subscribed_{0};  // written by the owner; read by the thread that connects
  AwaitedEvents awaited_;
  bool handling_ = false;       // a handler of an event is running
  bool handledInWait_ = false;  // events other than the one waited for
};

}  // namespace suture
