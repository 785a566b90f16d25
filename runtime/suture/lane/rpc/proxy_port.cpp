#include <suture/base/slots/shared_slot.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/receiver.h>
#include <suture/rt/counter.h>
#include <suture/wire/codec.h>
#include <suture/wire/stamps.h>

#include <algorithm>

namespace suture::rpc {
namespace {

/// Returns how many words the largest payload of an event takes.
std::size_t mostWords(const InterfaceInfo& contract) {
  std::uint32_t most = 0;
  for (const EventInfo& one : contract.events) most = std::max(most, one.payloadSize);
  return (most + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
}

}  // namespace

ProxyPort::ProxyPort(ControlThread& control, std::shared_ptr<Channel> channel,
                     std::shared_ptr<const LinkCounters> counters)
    : ClientEnd(std::move(channel)),
      control_(control),
      counters_(std::move(counters)),
      payload_(mostWords(channel_->info)),
      calls_(*this) {}

ProxyPort::~ProxyPort() noexcept(false) { close(ChannelStatus::Closed); }

void ProxyPort::open(capnp::Capability::Client provider) {
  provider_ = kj::mv(provider);
  channel_->takeJoining();  // the provider has been told with the request to connect
  subscribe(channel_->subscribed(), channel_->state->demand());
  control_.add(*this);
  pump();
}

// The capability stays: an answer that has arrived already may be on its way through it.
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
void ProxyPort::publish(capnp::AnyPointer::Reader in) {
  if (isClosed()) return;
  const RowCodec& row = info().codec().row;
  const rt::RowColumns columns = row.decode(in, info().wireColumns, shift(), *channel_->state);
  channel_->state->publish(here(row.stamp(in)), columns);
  if (channel_->wantsRows.isUp(std::memory_order_relaxed)) channel_->ends.client->ring();
}

kj::Promise<void> ProxyPort::event(std::uint16_t event, capnp::AnyPointer::Reader in) {
  const EventInfo& known = info().events[event];
  auto* const slot = reinterpret_cast<std::byte*>(payload_.data());
  if (known.sharedPayload) putSharedSlot(slot, nullptr);
  KJ_DEFER(if (known.sharedPayload) releaseSharedSlot(slot));
  const EventCodec& codec = info().codec().events[event];
  const Errc error = codec.payload.decode(in, slot, shift());
  if (error != Errc{}) return remoteError(error);
  if (!channel_->admits(known, slot)) {
    return remoteError(Errc::Invalid, channel_->lastInvalid.read());
  }
  push(event, slot, codec.stamp.of(in));
  return acknowledge();
}

void ProxyPort::push(std::uint16_t event, const std::byte* slot, std::int64_t stamp) {
  if (isClosed() || (leaving_ >> event & 1) != 0) return;
  channel_->events.push(event, here(stamp), {slot, channel_->info.events[event].payloadSize});
  channel_->ends.client->ring(rt::RungFor::Arrival);
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
  calls_.add(ask(events_ & ~events, columns_).then([this] {
    if (--farewellsUnderWay_ == 0) leaving_ = 0;
  }));
}

void ProxyPort::subscribe(EventSet events, rt::ColumnSet columns) {
  events_ = events;
  columns_ = columns;
  calls_.add(ask(events_, columns_).then([this] { countBytes(); }));
}

// Asks for these events and columns, in place of what was asked for before.
kj::Promise<void> ProxyPort::ask(EventSet events, rt::ColumnSet columns) {
  KJ_IF_MAYBE (provider, provider_) {
    auto request = provider->typelessRequest(info().codec().contract, 0, nullptr);
    auto out = request.initAs<wire::Subscription>();
    out.setEvents(kj::heap<Receiver>(kj::addRef(*this)));
    out.setEventMask(toWireNumbers(info().wireEvents, events));
    out.setStateMask(toWireNumbers(info().wireColumns, columns));
    return request.send().ignoreResult();
  }
  return kj::READY_NOW;
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
    answer(call, Errc::Cancelled);
    channel_->commands.returnCredit(command);
    rt::increment(channel_->commands.counters.cancelled);
    return;
  }
  if (channel_->info.commands[command].latest && call == 0) ++latestInFlight_;
  releaseAcknowledgement();
  KJ_IF_MAYBE (provider, provider_) {
    calls_.add(send(*provider, record)
                   .then([this, command, call] { returned(command, call, Errc{}); },
                         [this, command, call](kj::Exception&& e) {
                           returned(command, call, errcOf(e));
                         }));
  }
}

// Rejects with remoteError(), or as a broken link does.
kj::Promise<void> ProxyPort::send(capnp::Capability::Client& provider,
                                  const rt::CommandRecord& record) {
  const CommandCodec& codec = info().codec().commands[record.command];
  auto request = provider.typelessRequest(codec.interface, codec.method, nullptr);
  codec.arguments.encode(record.arguments(), request);
  wire::Sent::Builder sent = codec.sent.in(request);
  sent.setStamp(toNanoseconds(record.stamp));
  sent.setAnswer(record.call != 0);
  return request.send().then([this, command = record.command, call = record.call](auto&& response) {
    if (call != 0) answer(command, call, response);
  });
}

void ProxyPort::answer(std::uint16_t command, std::uint32_t call,
                       capnp::AnyPointer::Reader results) {
  if (isClosed()) return;
  const CommandInfo& known = info().commands[command];
  const CommandCodec& codec = info().codec().commands[command];
  const auto decode = [&](std::byte* slot) { return codec.result.decode(results, slot, shift()); };
  channel_->reply(call, {known.resultSize, known.sharedResult}, decode,
                  here(codec.stamp.of(results)));
  channel_->ends.client->ring(rt::RungFor::Arrival);
}

void ProxyPort::answer(std::uint32_t call, Errc error) {
  if (isClosed()) return;
  channel_->replyError(call, error);
  channel_->ends.client->ring(rt::RungFor::Arrival);
}

void ProxyPort::returned(std::uint16_t command, std::uint32_t call, Errc error) {
  if (error != Errc{} && call != 0) answer(call, error);
  if (channel_->info.commands[command].latest && call == 0) {
    if (latestInFlight_-- == kWindow) pumpCommands();
  } else {
    channel_->commands.returnCredit(command);
  }
}

// Only a subscription ends here: the link is breaking, and whoever watches it closes this.
void ProxyPort::taskFailed(kj::Exception&&) {}

}  // namespace suture::rpc
