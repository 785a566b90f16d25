#include <suture/base/virtual_time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/events.h>
#include <suture/component/required_tables.h>

#include <utility>

namespace suture {

Result<void> Emitter<void>::operator()() {
  return resultOf<void>(provided_.emit(event_, nullptr, true));
}

Result<void> SubscriptionBase::reset() { return resultOf<void>(required_.unsubscribe(event_)); }

Result<void> Subscription<void>::operator()(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return resultOf<void>(
      required_.subscribe(event_, [handler = std::move(handler)](const std::byte*) { handler(); }));
}

Result<void> Subscription<void>::direct(std::function<void()> handler) {
  if (handler == nullptr) return reset();
  return resultOf<void>(required_.subscribe(
      event_, [handler = std::move(handler)](const std::byte*) { handler(); }, true));
}

NextEvent<void> Subscription<void>::next() { return {required_, event_}; }

// --- what RequiredBase does for them

Result<void> RequiredBase::handle(std::uint16_t event,
                                  std::function<void(const std::byte*, Time)> handler) {
  return resultOf<void>(subscribe(event, [handler = std::move(handler)](const std::byte* payload) {
    handler(payload, rt::EventRecord::of(payload).stamp);
  }));
}

Errc RequiredBase::subscribe(std::uint16_t event, EventHandler handler, bool direct) {
  if (owner_.ownedByAnotherThread()) return Errc::WrongThread;
  if (handler == nullptr) return unsubscribe(event);
  Tables::HeardEvent& heard = tables_->events[event];
  const bool joins = heard.handler == nullptr;
  if (joins) heard.since = now();
  heard.handler = std::make_shared<const EventHandler>(std::move(handler));
  heard.direct = direct;
  lendHandler(event);
  const EventSet bit = EventSet{1} << event;
  subscribed_.fetch_or(bit, std::memory_order_relaxed);
  passSubscriptionsOn(joins ? bit : 0);
  return Errc{};
}

Errc RequiredBase::unsubscribe(std::uint16_t event) {
  if (owner_.ownedByAnotherThread()) return Errc::WrongThread;
  tables_->events[event].handler = nullptr;
  tables_->events[event].direct = false;
  lendHandler(event);
  if (!isAwaited(event)) {
    subscribed_.fetch_and(~(EventSet{1} << event), std::memory_order_relaxed);
  }
  passSubscriptionsOn(0);
  return Errc{};
}

void RequiredBase::lendHandler(std::uint16_t event) {
  if (channel_ == nullptr || channel_->ends.here == nullptr) return;
  const Tables::HeardEvent& heard = tables_->events[event];
  if (!heard.direct && (channel_->direct.events() >> event & 1) == 0) return;
  channel_->direct.set(event, owner_, heard.direct ? heard.handler : nullptr);
  if (heard.direct) refuseAwaited(event);
}

void RequiredBase::passSubscriptionsOn(EventSet joining) {
  if (channel_ == nullptr) return;
  if (joining == 0 && channel_->subscribed() == subscribed()) return;
  channel_->subscribe(subscribed(), joining);
  // Once the connection is over, what is at the far end may be gone: do not ring it.
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  if (isOver(status)) return;
  const Channel::Ends& ends = channel_->ends;
  owner_.ringLater(*ends.provider);
  if (ends.device != nullptr) ends.device->greetLocal(*channel_);
}

std::size_t RequiredBase::handleQueuedEvents() {
  const std::shared_ptr<Channel> channel = channel_;
  if (channel == nullptr) return 0;
  noteTaking();
  std::size_t handled = 0;
  // A task that is asked to stop ends after this handler; a collector takes the rest in onStop().
  const bool atItsEnd = owner_.ending();
  // A provider that emits faster than they are handled must not keep the task from its cycle. What
  // is left of a connection that a handler of a device has found over is not heard.
  while (channel_ == channel && handled < channel->events.capacity() &&
         (atItsEnd || !owner_.ending())) {
    const rt::EventRecord* const record = channel->events.next();
    if (record == nullptr) break;
    // Release the event even if the handler throws: it must not meet the same event again.
    struct Release {
      rt::EventQueue& events;
      bool& handling;
      ~Release() {
        handling = false;
        events.pop();
      }
    } release{channel->events, handling_};
    handling_ = true;
    deliver(*record);
    ++handled;
  }
  return handled;
}

void RequiredBase::deliver(const rt::EventRecord& record) {
  const EventInfo& info = info_.events[record.event];
  channel_->countReceived(sizeof(record) + info.payloadSize);
  // Judge the copy of a foreign event: on other lanes it was judged before it came here.
  if (channel_->foreign && !channel_->admits(info, record.payload())) {
    return channel_->events.countDropped();
  }
  satisfyAwaited(record);
  const Tables::HeardEvent& heard = tables_->events[record.event];
  // The value of a latched event may be older than its subscription, for it is a replay.
  if (record.stamp < heard.since && !info.latched) return;
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->note(VirtualTime::Kind::Event, name_.c_str(), info.name, channel_->events.delivered());
  }
  const auto handler = heard.handler;  // lives on if it ends its own subscription
  if (handler != nullptr) (*handler)(record.payload());
}

}  // namespace suture
