#include <suture/codec/codec.h>
#include <suture/codec/tallies.h>
#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/credit.h>
#include <suture/lane/carrier/arrival_stamp.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/loop/deadline.h>

#include <algorithm>

namespace suture::rpc {
namespace {

// Bounds the notices, because one for each cycle of a task would make each round trip a tenth
// slower.
constexpr Duration kTallyPause = std::chrono::milliseconds(5);

}  // namespace

ServantPort::ServantPort(loop::ControlThread& control, std::shared_ptr<Channel> channel,
                         std::shared_ptr<const framing::LinkCounters> counters)
    : ProviderEnd(std::move(channel)),
      control_(control),
      counters_(std::move(counters)),
      taken_(channel_->info.commands.size()),
      calls_(callLimitOf(channel_->info).calls),
      row_(channel_->info),
      carrier_(*channel_, *this),
      sending_(*this) {
  control_.add(*this);
}

ServantPort::~ServantPort() noexcept(false) { close(); }

void ServantPort::ending() {
  control_.remove(*this);
  subscriber_ = nullptr;
  counts_ = nullptr;
  for (auto& waiting : taken_) {
    for (Taken& call : waiting) call = Taken();
  }
  for (PendingCall& call : calls_) call = PendingCall{};
}

kj::Promise<void> ServantPort::command(std::uint16_t command, AnyCall call) {
  const codec::CommandCodec& codec = channel_->info.codec().commands[command];
  const auto parameters = call.getParams();
  const CommandInfo& info = channel_->info.commands[command];
  if (info.resultSize > 0 || codec.sent.of(parameters).getAnswer()) return await(command, call);
  const Refusal refusal = post(command, parameters, 0);
  if (refusal.error != Errc{}) return turnedAway(refusal);
  call.releaseParams();  // many may wait, and a message may be large
  return whenTaken(command);
}

kj::Promise<void> ServantPort::await(std::uint16_t command, AnyCall call) {
  PendingCall* const pending = openCall(command);
  if (pending == nullptr) return turnedAway({Errc::TooManyCalls});
  const Refusal refusal = post(command, call.getParams(), pending->number);
  if (refusal.error != Errc{}) return turnedAway(refusal);
  call.releaseParams();
  carrier_.lend(command);
  taken_[command].emplace_back();  // null, because it does not wait for its credit
  auto pair = kj::newPromiseAndFulfiller<void>();
  pending->done = kj::mv(pair.fulfiller);
  pending->call = call;
  return kj::mv(pair.promise);
}

ServantPort::Refusal ServantPort::post(std::uint16_t command, capnp::AnyPointer::Reader in,
                                       std::uint32_t call) {
  const codec::CommandCodec& codec = channel_->info.codec().commands[command];
  const Time sent = arrivalStamp(*channel_, codec.sent.of(in).getStamp());
  const Refusal refusal = carrier_.post(command, sent, call, [&](std::byte* arguments) {
    return codec.arguments.decode(in, arguments, channel_->clockShift());
  });
  provider_.arrived();
  return refusal;
}

// A closed port must keep nothing of its client, whose capabilities may keep the port in turn.
void ServantPort::tellCounts(wire::CommandCounts::Client counts) {
  if (!isClosed()) counts_ = kj::mv(counts);
}

void ServantPort::subscribe(Subscriber subscriber, Interest interest) {
  if (isClosed()) return;
  subscriber_ = kj::mv(subscriber);
  interest.number = ++subscriptions_;
  interest.joining |= ~channel_->subscribed();
  carrier_.subscribe(interest);
  provider_.arrived();
  answering_ = true;
  sending_.add(kj::evalLast([this] {
    answering_ = false;
    carrier_.giveEvents();
    carrier_.giveRow();
  }));
}

kj::Promise<void> ServantPort::turnedAway(const Refusal& refusal) {
  carrier_.countRefused();
  carrier_.giveTally();
  return framing::remoteError(refusal.error, refusal.invalid);
}

kj::Promise<void> ServantPort::whenTaken(std::uint16_t command) {
  if (!usesCredit(channel_->info.commands[command], 0)) return kj::READY_NOW;
  carrier_.lend(command);
  auto pair = kj::newPromiseAndFulfiller<void>();
  taken_[command].push_back(kj::mv(pair.fulfiller));
  return kj::mv(pair.promise);
}

ServantPort::PendingCall* ServantPort::openCall(std::uint16_t command) {
  const auto free = std::find_if(calls_.begin(), calls_.end(), [](const PendingCall& call) {
    return call.done.get() == nullptr;
  });
  if (free == calls_.end()) return nullptr;
  free->number = ++callsOpened_ == 0 ? ++callsOpened_ : callsOpened_;
  free->command = command;
  return &*free;
}

void ServantPort::pump() {
  channel_->bytesSent.store(counters_->sentBytes, std::memory_order_relaxed);
  channel_->bytesReceived.store(counters_->receivedBytes, std::memory_order_relaxed);
  carrier_.give();
  pumpStatus();
}

bool ServantPort::hasRoom(Message message) const {
  switch (message) {
    case Message::Reply:
    case Message::Credits: return true;
    case Message::Tally: return counts_ != nullptr && !tallyInFlight_;
    case Message::Event: return isHeard() && eventsInFlight_ < kWindow;
    case Message::Row: return isHeard() && rowsInFlight_ < kWindow;
  }
  return false;
}

void ServantPort::send(const ReplyRecord& reply) {
  for (PendingCall& call : calls_) {
    if (call.number != reply.call || call.done.get() == nullptr) continue;
    if (reply.error == Errc{}) {
      answer(call, reply);
    } else {
      call.done->reject(failureOf(call, reply.error));
    }
    call = PendingCall{};
  }
  carrier_.replySent();
}

void ServantPort::answer(PendingCall& pending, const ReplyRecord& reply) {
  const codec::CommandCodec& codec = channel_->info.codec().commands[pending.command];
  KJ_IF_MAYBE (call, pending.call) {
    auto out = call->getResults();
    codec.result.encode(reply.result(), out);
    codec.stamp.set(out, toNanoseconds(reply.stamp));
  }
  pending.done->fulfill();
}

// The provider noted what is invalid before it answered. If it answered two calls of one command
// with Errc::Invalid, both get what the later one had.
kj::Exception ServantPort::failureOf(const PendingCall& call, Errc error) const {
  if (error != Errc::Invalid) return framing::remoteError(error);
  const FieldPath last = channel_->lastInvalid.read();
  const bool isOfThis = last.beginsWith(channel_->info.commands[call.command].name);
  return framing::remoteError(error, isOfThis ? last : FieldPath());
}

void ServantPort::sendCredits(std::uint16_t command, std::uint32_t count) {
  auto& calls = taken_[command];
  for (; count > 0; --count) {
    if (calls.front().get() != nullptr) calls.front()->fulfill();
    calls.pop_front();
  }
}

void ServantPort::send(const Tally& tally) {
  KJ_IF_MAYBE (counts, counts_) {
    tallyInFlight_ = true;
    auto request = counts->tellRequest();
    codec::toWire(tally, request.initTally());
    sending_.add(request.send()
                     .ignoreResult()
                     .catch_([](kj::Exception&&) {})
                     .then([this] { return control_.timer().afterDelay(loop::toKj(kTallyPause)); })
                     .then([this] {
                       tallyInFlight_ = false;
                       carrier_.giveTally();
                     }));
  }
}

void ServantPort::send(const rt::EventRecord& event, std::uint32_t subscription) {
  KJ_IF_MAYBE (subscriber, subscriber_) {
    ++eventsInFlight_;
    auto fail = [this, subscription](kj::Exception&& failure) {
      if (!isGone(failure, subscription)) channel_->events.countDropped();
      eventTaken();
    };
    sending_.add(subscriber->event(event).then([this] { eventTaken(); }, kj::mv(fail)));
  }
  carrier_.eventSent();
}

void ServantPort::eventTaken() {
  --eventsInFlight_;
  carrier_.giveEvents();
}

// Loses only an event or row that exceeds a message, or that the subscriber refuses, because a
// damaged one must not silence a connection that counts as connected. A subscriber that is gone
// ends its subscription, but not a later one.
bool ServantPort::isGone(const kj::Exception& failure, std::uint32_t subscription) {
  const bool gone = failure.getType() == kj::Exception::Type::DISCONNECTED;
  if (gone && subscription == subscriptions_) subscriber_ = nullptr;
  return gone;
}

bool ServantPort::sendRow(rt::ColumnSet columns, std::uint64_t& last) {
  if (channel_->state->rows() == last) return false;
  KJ_IF_MAYBE (subscriber, subscriber_) {
    rt::StateTable::Row row = channel_->state->readRow(row_.of(columns));
    last = row.sequence;
    row.keep(columns);
    if (row.any()) sendRow(*subscriber, row);
    releaseRow();
  }
  return false;
}

void ServantPort::sendRow(Subscriber& subscriber, const rt::StateTable::Row& row) {
  ++rowsInFlight_;
  auto fail = [this, row, subscription = subscriptions_](kj::Exception&& failure) {
    if (!isGone(failure, subscription)) tellTooLarge(row, failure);
    rowTaken();
  };
  sending_.add(subscriber.row(row, row_.slots()).then([this] { rowTaken(); }, kj::mv(fail)));
}

void ServantPort::tellTooLarge(rt::StateTable::Row row, const kj::Exception& failure) {
  if (framing::errcOf(failure) != Errc::TooLarge) return;
  row.tooLarge |= std::exchange(row.valid, 0);
  KJ_IF_MAYBE (subscriber, subscriber_) sendRow(*subscriber, row);
}

void ServantPort::rowTaken() {
  --rowsInFlight_;
  carrier_.giveRow();
}

void ServantPort::releaseRow() {
  const auto slots = row_.slots();
  for (unsigned i = 0; i < slots.size(); ++i) {
    if (slots[i] != nullptr && channel_->state->isShared(i)) releaseSharedSlot(slots[i]);
  }
}

void ServantPort::changed(ChannelStatus status) {
  const Errc end = endOfCalls(status);
  if (end == Errc{}) return;
  carrier_.giveReplies();  // an answer may have come just before the end
  failAll(end);
}

void ServantPort::failAll(Errc error) {
  for (PendingCall& call : calls_) {
    if (call.done.get() != nullptr) call.done->reject(framing::remoteError(error));
    call = PendingCall{};
  }
  for (auto& calls : taken_) {
    for (auto& call : calls) {
      if (call.get() != nullptr) call->reject(framing::remoteError(error));
      call = Taken();  // it still uses its credit
    }
  }
}

// The subscriber does not answer any more; what ends the connection learns of that elsewhere.
void ServantPort::taskFailed(kj::Exception&&) { subscriber_ = nullptr; }

}  // namespace suture::rpc
