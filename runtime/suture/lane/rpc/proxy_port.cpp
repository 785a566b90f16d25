#include <suture/base/slots/shared_slot.h>
#include <suture/base/words.h>
#include <suture/codec/codec.h>
#include <suture/component/channel/credit.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/carrier/arrival_stamp.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/receiver.h>
#include <suture/loop/failure.h>

namespace suture::rpc {

ProxyPort::ProxyPort(loop::ControlThread& control, std::shared_ptr<Channel> channel,
                     std::shared_ptr<const framing::LinkCounters> counters)
    : ClientEnd(std::move(channel)),
      control_(control),
      counters_(std::move(counters)),
      payload_(wordBytes(largestSlot(channel_->info)) / sizeof(std::uint64_t)),
      carrier_(*channel_, *this),
      calls_(*this) {}

ProxyPort::~ProxyPort() noexcept(false) { close(ChannelStatus::Closed); }

void ProxyPort::open(capnp::Capability::Client provider, std::shared_ptr<const CallsLink> link) {
  provider_ = kj::mv(provider);
  link_ = std::move(link);
  control_.add(*this);
  pump();
}

// Keeps the capability, because an answer that has arrived already may be on its way through it.
// Drops the link, which holds what holds this.
void ProxyPort::ending() {
  control_.remove(*this);
  releaseAcknowledgement();
  link_ = nullptr;
}

void ProxyPort::countBytes() {
  channel_->bytesSent.store(counters_->sentBytes, std::memory_order_relaxed);
  channel_->bytesReceived.store(counters_->receivedBytes, std::memory_order_relaxed);
}

// ---- from the provider

void ProxyPort::tally(const Tally& tally) {
  carrier_.tally(tally);
  if (!isClosed()) client_.arrived();
}

// A row of another process is checked where the client reads it.
void ProxyPort::publish(capnp::AnyPointer::Reader in) {
  if (isClosed()) return;
  const codec::RowCodec& row = info().codec().row;
  const rt::RowColumns columns = row.decode(in, info().wireColumns, shift(), *channel_->state);
  carrier_.row(arrivalStamp(*channel_, row.stamp(in)), columns);
  client_.arrived();
}

kj::Promise<void> ProxyPort::event(std::uint16_t event, std::uint32_t subscription,
                                   capnp::AnyPointer::Reader in) {
  if (isClosed()) return kj::READY_NOW;
  const EventInfo& known = info().events[event];
  auto* const slot = reinterpret_cast<std::byte*>(payload_.data());
  if (known.sharedPayload) putSharedSlot(slot, nullptr);
  KJ_DEFER(if (known.sharedPayload) releaseSharedSlot(slot));
  const codec::EventCodec& codec = info().codec().events[event];
  const Errc error = codec.payload.decode(in, slot, shift());
  if (error != Errc{}) return framing::remoteError(error);
  const Time stamp = arrivalStamp(*channel_, codec.stamp.of(in));
  if (!carrier_.event(event, subscription, stamp, slot)) {
    return framing::remoteError(Errc::Invalid, channel_->lastInvalid.read());
  }
  client_.arrived();
  return acknowledge();
}

kj::Promise<void> ProxyPort::acknowledge() {
  releaseAcknowledgement();
  auto pair = kj::newPromiseAndFulfiller<void>();
  acknowledgement_ = kj::mv(pair.fulfiller);
  return kj::mv(pair.promise);
}

void ProxyPort::releaseAcknowledgement() {
  KJ_IF_MAYBE (answer, acknowledgement_) (*answer)->fulfill();
  acknowledgement_ = nullptr;
}

void ProxyPort::answer(std::uint16_t command, std::uint32_t call,
                       capnp::AnyPointer::Reader results) {
  if (isClosed()) return;
  const codec::CommandCodec& codec = info().codec().commands[command];
  const Time stamp = arrivalStamp(*channel_, codec.stamp.of(results));
  carrier_.reply(call, stamp,
                 [&](std::byte* slot) { return codec.result.decode(results, slot, shift()); });
  client_.arrived();
}

// The provider counts what it rejects, but it has never heard of a command that was too large.
void ProxyPort::rejected(std::uint16_t command, std::uint32_t call,
                         const kj::Exception& exception) {
  const Errc error = framing::errcOf(exception);
  if (error == Errc::TooLarge && !loop::isRemote(exception)) carrier_.countRefused();
  returned(command, call, error);
}

void ProxyPort::returned(std::uint16_t command, std::uint32_t call, Errc error) {
  if (error != Errc{} && !isClosed()) carrier_.replyError(call, error);
  if (usesCredit(info().commands[command], call)) {
    carrier_.credits(command, 1);
    client_.arrived();
  } else if (latestInFlight_-- == kWindow) {
    carrier_.give();
  }
}

// ---- to the provider

void ProxyPort::pump() {
  countBytes();
  if (link_ != nullptr && link_->broken()) tellBroken("closed: the link of its calls has ended");
  carrier_.give();
}

bool ProxyPort::hasRoom(ClientCarrier::Message message) const {
  if (isClosed()) return false;
  return message == ClientCarrier::Message::Interest || latestInFlight_ < kWindow;
}

// Events come through the capability of the subscription that they were emitted for.
void ProxyPort::send(const Interest& interest) {
  KJ_IF_MAYBE (provider, provider_) {
    auto request = provider->typelessRequest(info().codec().contract, 0, nullptr);
    auto out = request.initAs<wire::Subscription>();
    out.setEvents(kj::heap<Receiver>(kj::addRef(*this), interest.number));
    out.setEventMask(toWireNumbers(info().wireEvents, interest.events));
    out.setJoinMask(toWireNumbers(info().wireEvents, interest.joining));
    out.setStateMask(toWireNumbers(info().wireColumns, interest.columns));
    calls_.add(request.send().ignoreResult().then([this] { countBytes(); }));
  }
}

// The call is rejected with remoteError(), or as a broken link does.
void ProxyPort::send(const rt::CommandRecord& record) {
  const std::uint16_t command = record.command;
  const std::uint32_t call = record.call;
  if (!usesCredit(info().commands[command], call)) ++latestInFlight_;
  releaseAcknowledgement();
  KJ_IF_MAYBE (provider, provider_) {
    const codec::CommandCodec& codec = info().codec().commands[command];
    auto request = provider->typelessRequest(codec.interface, codec.method, nullptr);
    codec.arguments.encode(record.arguments(), request);
    wire::Sent::Builder sent = codec.sent.in(request);
    sent.setStamp(toNanoseconds(record.stamp));
    sent.setAnswer(call != 0);
    auto answered = request.send().then([this, command, call](auto&& response) {
      if (call != 0) answer(command, call, response);
    });
    calls_.add(
        answered.then([this, command, call] { returned(command, call, Errc{}); },
                      [this, command, call](kj::Exception&& e) { rejected(command, call, e); }));
  }
  carrier_.commandSent();
}

// Only a subscription can fail here. The link is breaking then, and whoever watches it closes this.
void ProxyPort::taskFailed(kj::Exception&&) {}

}  // namespace suture::rpc
