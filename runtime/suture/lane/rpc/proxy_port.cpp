#include <suture/lane/rpc/proxy_port.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace suture::rpc {
ProxyPort::ProxyPort(ControlThread& control, std::shared_ptr<Channel> channel,
                     std::shared_ptr<const LinkCounters> counters)
    : ClientEnd(std::move(channel)),
      control_(control),
      counters_(std::move(counters)),
      replays_(channel_->info.events.size()),
      calls_(*this) {}

ProxyPort::~ProxyPort() noexcept(false) { close(ChannelStatus::Closed); }

void ProxyPort::open(kj::Own<Proxy> proxy) {
  proxy_ = kj::mv(proxy);
  channel_->takeJoining();  // the provider has been told with the request to connect
  subscribe(channel_->subscribed(), channel_->state->demand());
  control_.add(*this);
  pump();
}

// The proxy stays: an answer that has arrived already may be on its way through it.
void ProxyPort::ending() {
  control_.remove(*this);
  releaseAcknowledgement();
}

// Bounds stamps by now, since what has not happened yet would have a negative age.
Time ProxyPort::here(std::int64_t stamp) const {
  const Time received = now();
  return stamp == 0 ? received : std::min(received, fromNanoseconds(shifted(stamp, shift())));
}

// A row of another process is judged where the client reads it.
void ProxyPort::publish(std::int64_t stamp, const rt::RowColumns& columns) {
  if (isClosed()) return;
  channel_->state->publish(here(stamp), columns);
  if (channel_->wantsRows.isUp(std::memory_order_relaxed)) channel_->ends.client->ring();
}

void ProxyPort::push(std::uint16_t event, const std::byte* slot) {
  const Time stamp = here(std::exchange(replays_[event], 0));
  if (isClosed() || (leaving_ >> event & 1) != 0) return;
  channel_->events.push(event, stamp, {slot, channel_->info.events[event].payloadSize});
  channel_->ends.client->ring(rt::RungFor::Arrival);
}

void ProxyPort::noteReplay(std::uint16_t event, std::int64_t stamp) {
  if (event >= std::numeric_limits<EventSet>::digits) return;
  const EventSet here = fromWireNumbers(channel_->info.wireEvents, EventSet{1} << event);
  const auto place = static_cast<std::size_t>(std::countr_zero(here));
  if (place < replays_.size()) replays_[place] = stamp;
}

kj::Promise<void> ProxyPort::acknowledge() {
  releaseAcknowledgement();
  if (isClosed()) return kj::READY_NOW;
  auto pair = kj::newPromiseAndFulfiller<void>();
  acknowledgement_ = kj::mv(pair.fulfiller);
  return kj::mv(pair.promise);
}

void ProxyPort::releaseAcknowledgement() {
  KJ_IF_MAYBE (answer, acknowledgement_) (*answer)->fulfill();
  acknowledgement_ = nullptr;
}

void ProxyPort::countBytes() {
  channel_->bytesSent.store(counters_->sentBytes, std::memory_order_relaxed);
  channel_->bytesReceived.store(counters_->receivedBytes, std::memory_order_relaxed);
}

void ProxyPort::pump() {
  countBytes();
  pumpSubscription();
  pumpCommands();
}

void ProxyPort::pumpSubscription() {
  const rt::ColumnSet columns = channel_->state->demand();
  const EventSet joining = channel_->takeJoining(), events = channel_->subscribed();
  if (isClosed() || (columns == columns_ && events == events_ && joining == 0)) return;
  if (const EventSet again = joining & events_; again != 0) leave(again);
  subscribe(events, columns);
}

// Leaves events that the client has left and subscribed to again since this end last asked.
void ProxyPort::leave(EventSet events) {
  leaving_ |= events;
  ++farewellsUnderWay_;
  KJ_IF_MAYBE (proxy, proxy_) {
    calls_.add((*proxy)->subscribe(events_ & ~events, columns_).then([this] {
      if (--farewellsUnderWay_ == 0) leaving_ = 0;
    }));
  }
}

void ProxyPort::subscribe(EventSet events, rt::ColumnSet columns) {
  events_ = events;
  columns_ = columns;
  KJ_IF_MAYBE (proxy, proxy_) {
    calls_.add((*proxy)->subscribe(events_, columns_).then([this] { countBytes(); }));
  }
}

void ProxyPort::pumpCommands() {
  rt::Mailbox& commands = channel_->commands;
  if (isClosed() || latestInFlight_ >= kWindow || !commands.pending()) return;
  commands.fixCut();
  pumpSubscription();  // ahead of commands that were sent later
  while (const rt::CommandRecord* record = commands.next()) {
    transmit(*record);
    commands.pop();
  }
}

void ProxyPort::transmit(const rt::CommandRecord& record) {
  const std::uint16_t command = record.command;
  const std::uint32_t call = record.call;
  if (call != 0 && !channel_->claimCall(call)) {
    reply(call, {}, [](std::byte*) { return Errc::Cancelled; });
    channel_->commands.returnCredit(command);
    rt::increment(channel_->commands.counters.cancelled);
    return;
  }
  if (channel_->info.commands[command].latest && call == 0) ++latestInFlight_;
  releaseAcknowledgement();
  KJ_IF_MAYBE (proxy, proxy_) {
    calls_.add((*proxy)->send(record).then(
        [this, command, call] { returned(command, call, Errc{}); },
        [this, command, call](kj::Exception&& e) { returned(command, call, errcOf(e)); }));
  }
}

void ProxyPort::returned(std::uint16_t command, std::uint32_t call, Errc error) {
  if (error != Errc{} && call != 0) reply(call, {}, [error](std::byte*) { return error; });
  if (channel_->info.commands[command].latest && call == 0) {
    if (latestInFlight_-- == kWindow) pumpCommands();
  } else {
    channel_->commands.returnCredit(command);
  }
}

// Only a subscription ends here: the link is breaking, and whoever watches it closes this.
void ProxyPort::taskFailed(kj::Exception&&) {}

}  // namespace suture::rpc
