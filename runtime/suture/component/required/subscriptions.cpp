#include <suture/base/virtual_time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/component/required/subscriptions.h>
#include <suture/component/sleep.h>

#include <utility>

namespace suture {

Subscriptions::Subscriptions(Attachment& attachment)
    : attachment_(attachment), heard_(attachment.info().events.size()) {
  attachment.inform(*this);
}

Errc Subscriptions::subscribe(std::uint16_t event, Handler handler, bool direct) {
  if (attachment_.owner().ownedByAnotherThread()) return Errc::WrongThread;
  if (handler == nullptr) return unsubscribe(event);
  Heard& heard = heard_[event];
  const bool joins = heard.handler == nullptr;
  if (joins) begin(event);
  heard.handler = std::make_shared<const Handler>(std::move(handler));
  heard.direct = direct;
  lendHandler(event);
  const EventSet bit = EventSet{1} << event;
  subscribed_.fetch_or(bit, std::memory_order_relaxed);
  passOn(joins ? bit : 0);
  return Errc{};
}

// A subscription hears no event from before it began. Such an event may still be on its way, so its
// stamp tells. A latched event is told by its place in the queue instead: its last value, which the
// subscriber is to hear, is older than the subscription too.
void Subscriptions::begin(std::uint16_t event) {
  heard_[event].since = now();
  Channel* const channel = attachment_.channel().get();
  if (channel != nullptr && attachment_.info().events[event].latched) {
    channel->events.beginAnew(event);
  }
}

Errc Subscriptions::unsubscribe(std::uint16_t event) {
  if (attachment_.owner().ownedByAnotherThread()) return Errc::WrongThread;
  heard_[event].handler = nullptr;
  heard_[event].direct = false;
  lendHandler(event);
  if (!awaited_.contain(event)) {
    subscribed_.fetch_and(~(EventSet{1} << event), std::memory_order_relaxed);
  }
  passOn(0);
  return Errc{};
}

// Tells the channel what has been subscribed to since it was made.
void Subscriptions::join() {
  for (std::uint16_t event = 0; event < heard_.size(); ++event) lendHandler(event);
  const Channel* const channel = attachment_.channel().get();
  if (channel != nullptr) passOn(subscribed() & ~channel->subscribed());
}

void Subscriptions::lendHandler(std::uint16_t event) {
  Channel* const channel = attachment_.channel().get();
  if (channel == nullptr || channel->ends.here == nullptr) return;
  const Heard& heard = heard_[event];
  if (!heard.direct && (channel->direct.events() >> event & 1) == 0) return;
  channel->direct.set(event, attachment_.owner(), heard.direct ? heard.handler : nullptr);
  if (heard.direct) awaited_.end(event, Errc::CannotWait);
}

void Subscriptions::passOn(EventSet joining) {
  Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return;
  if (joining == 0 && channel->subscribed() == subscribed()) return;
  channel->client.subscribe(subscribed(), joining);
  // Once the connection is over, the device at its far end may be gone, so do not touch it.
  const ChannelStatus status = channel->status.load(std::memory_order_acquire);
  if (isOver(status)) return;
  const Channel::Ends& ends = channel->ends;
  attachment_.owner().ringLater(*ends.provider);
  if (ends.device != nullptr) ends.device->emission_.greetLocal(*channel);
}

bool Subscriptions::pending() const {
  const Channel* const channel = attachment_.channel().get();
  return channel != nullptr && channel->events.pending();
}

std::size_t Subscriptions::handleQueued() {
  const std::shared_ptr<Channel> channel = attachment_.channel();
  if (channel == nullptr) return 0;
  channel->client.lowerUntaken();
  std::size_t handled = 0;
  // A task that is asked to stop ends after this handler; a collector takes the rest in onStop().
  const Component& owner = attachment_.owner();
  const bool atItsEnd = owner.ending();
  // A provider that emits faster than they are handled must not keep the task from its cycle. If a
  // handler of a device has found the connection over, the rest of its events is dropped.
  while (attachment_.channel() == channel && handled < channel->events.capacity() &&
         (atItsEnd || !owner.ending())) {
    const rt::EventRecord* const record = channel->events.next();
    if (record == nullptr) break;
    // Release the event even if the handler throws: it must not get the same event again.
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

void Subscriptions::deliver(const rt::EventRecord& record) {
  Channel& channel = *attachment_.channel();
  const EventInfo& info = attachment_.info().events[record.event];
  channel.countReceived(sizeof(record) + info.payloadSize);
  // Check the copy of a foreign event; those of other lanes were checked before they came here.
  if (channel.foreign && !channel.admits(info, record.payload())) {
    return channel.events.countDropped();
  }
  awaited_.satisfy(record);
  const Heard& heard = heard_[record.event];
  if (info.latched ? channel.events.fromBefore() : record.stamp < heard.since) return;
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->note(VirtualTime::Kind::Event, attachment_.name().c_str(), info.name,
               channel.events.delivered());
  }
  const auto handler = heard.handler;  // a copy, which lives on if the handler ends its own
                                       // subscription
  if (handler != nullptr) (*handler)(record.payload());
}

Errc Subscriptions::await(std::uint16_t event) {
  const Errc error = attachment_.unusable();
  if (error != Errc{} && error != Errc::Suspended) return error;
  if (heard_[event].direct && attachment_.channel()->ends.here != nullptr) return Errc::CannotWait;
  const EventSet bit = EventSet{1} << event;
  const EventSet before = subscribed_.fetch_or(bit, std::memory_order_relaxed);
  passOn(bit & ~before);
  return Errc{};
}

Errc Subscriptions::end() const {
  const Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return Errc::Lost;
  const ChannelStatus status = channel->status.load(std::memory_order_acquire);
  const bool over = status != ChannelStatus::Connected && status != ChannelStatus::Suspended;
  // Events that were emitted before the end are handled before it.
  if (!over || channel->events.pending()) return Errc{};
  return status == ChannelStatus::Faulted ? Errc::Faulted : Errc::Lost;
}

Errc Subscriptions::waitFor(AwaitedEvent& event, Duration limit) {
  Component& owner = attachment_.owner();
  if (owner.ownedByAnotherThread()) return Errc::WrongThread;
  if (handling_) return Errc::CannotWait;
  sleepUntil(owner, fromNow(limit), [&] {
    const std::size_t handled = handleArrivals();
    const bool over = event.over();
    if (handled > (over ? 1u : 0u)) handledInWait_ = true;
    return over;
  });
  return owner.mayWait() ? Errc::Timeout : Errc::Cancelled;
}

// Does what a cycle does first, except that a task's connections change only between its cycles.
std::size_t Subscriptions::handleArrivals() {
  if (!attachment_.owner().ownsThread()) attachment_.adopt();
  attachment_.noticeLoss();
  return handleQueued();
}

}  // namespace suture
