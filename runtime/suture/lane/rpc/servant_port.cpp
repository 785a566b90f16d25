#include <suture/component/channel/call_limit.h>
#include <suture/lane/rpc/servant_port.h>
#include <suture/loop/deadline.h>
#include <suture/rt/counter.h>
#include <suture/wire/codec.h>
#include <suture/wire/stamps.h>

#include <algorithm>

namespace suture::rpc {
namespace {

// A notice for each turn of a task would make each round trip a tenth slower.
constexpr Duration kTallyPause = std::chrono::milliseconds(5);

/// An event or row that exceeds a message, or that the subscriber refuses, is lost alone, since a
/// damaged one must not silence a connection that is told of as connected. Throws if the subscriber
/// is gone, which ends its subscription.
void throwIfGone(kj::Exception&& failure) {
  if (failure.getType() == kj::Exception::Type::DISCONNECTED) {
    kj::throwFatalException(kj::mv(failure));
  }
}

}  // namespace

ServantPort::ServantPort(ControlThread& control, std::shared_ptr<Channel> channel,
                         std::shared_ptr<const LinkCounters> counters)
    : ProviderEnd(std::move(channel)),
      control_(control),
      counters_(std::move(counters)),
      taken_(channel_->info.commands.size()),
      calls_(callLimitOf(channel_->info).calls),
      since_(channel_->info.events.size(), now()),
      sending_(*this) {
  for (unsigned i = 0; i < channel_->state->columns(); ++i) {
    rowSlots_.emplace_back((channel_->state->columnSize(i) + 7) / 8);
    rowPointers_.push_back(nullptr);
  }
  // This also tells when commands have been taken, if a provider publishes no rows.
  channel_->wantsRows.raise();
  control_.add(*this);
}

ServantPort::~ServantPort() noexcept(false) { close(); }

void ServantPort::ending() {
  control_.remove(*this);
  subscriber_ = nullptr;
  for (auto& waiting : taken_) waiting.clear();
  for (PendingCall& call : calls_) call = PendingCall{};
}

kj::Promise<void> ServantPort::command(std::uint16_t command, AnyCall call) {
  const CommandCodec& codec = channel_->info.codec().commands[command];
  const auto parameters = call.getParams();
  const CommandInfo& info = channel_->info.commands[command];
  if (info.resultSize > 0 || codec.sent.of(parameters).getAnswer()) return await(command, call);
  const Refusal refusal = post(command, parameters, 0);
  if (refusal.error != Errc{}) return turnedAway(refusal);
  return whenTaken(command);
}

kj::Promise<void> ServantPort::await(std::uint16_t command, AnyCall call) {
  PendingCall* const pending = openCall(command);
  if (pending == nullptr) return turnedAway({Errc::TooManyCalls});
  const Refusal refusal = post(command, call.getParams(), pending->number);
  if (refusal.error != Errc{}) return turnedAway(refusal);
  taken_[command].emplace_back();  // it uses a credit, and does not wait for it
  auto pair = kj::newPromiseAndFulfiller<void>();
  pending->done = kj::mv(pair.fulfiller);
  pending->call = call;
  return kj::mv(pair.promise);
}

ServantPort::Refusal ServantPort::post(std::uint16_t command, capnp::AnyPointer::Reader in,
                                       std::uint32_t call) {
  if (const Errc error = errorOf(channel_->status.load(std::memory_order_acquire));
      error != Errc{}) {
    return {error};
  }
  const CommandInfo& info = channel_->info.commands[command];
  const CommandCodec& codec = channel_->info.codec().commands[command];
  if (readOnly_ && !info.reads()) return {Errc::NotPermitted};
  const auto slot = channel_->commands.claim(command, stampOf(codec.sent.of(in)), call);
  if (!slot) return {slot.error()};
  Refusal refusal{codec.arguments.decode(in, *slot, channel_->clockShift())};
  if (refusal.error == Errc{} && !info.admits(*slot, &refusal.invalid)) {
    refusal.error = Errc::Invalid;
    channel_->lastInvalid.note(refusal.invalid);
  }
  if (refusal.error != Errc{}) {
    channel_->commands.abandon();
    return refusal;
  }
  channel_->commands.commit();
  channel_->ends.provider->ring();
  return {};
}

void ServantPort::subscribe(Subscriber subscriber, EventSet events, rt::ColumnSet columns) {
  subscriber_ = kj::mv(subscriber);
  const EventSet joining = events & ~channel_->subscribed();
  for (std::size_t i = 0; i < since_.size(); ++i) {
    if (joining >> i & 1) since_[i] = now();
  }
  channel_->subscribe(events, joining);
  columns_ = columns;
  lastRow_ = 0;
  bool first = joining != 0;
  for (unsigned i = 0; i < rowSlots_.size(); ++i) {
    const bool wanted = (columns >> i & 1) != 0;
    rowPointers_[i] = wanted ? reinterpret_cast<std::byte*>(rowSlots_[i].data()) : nullptr;
    first = (wanted && channel_->state->ask(i)) || first;
  }
  if (first) channel_->ends.provider->ring();
  answering_ = true;
  sending_.add(kj::evalLast([this] {
    answering_ = false;
    pumpEvents();
    pumpRow();
  }));
}

kj::Promise<void> ServantPort::turnedAway(const Refusal& refusal) {
  rt::increment(channel_->counts->turnedAway);
  pumpTally();
  return remoteError(refusal.error, refusal.invalid);
}

// Bounds stamps by now, since a command from the future would never be late.
Time ServantPort::stampOf(wire::Sent::Reader sent) const {
  const Time received = now();
  if (sent.getStamp() == 0) return received;
  return std::min(received, fromNanoseconds(shifted(sent.getStamp(), channel_->clockShift())));
}

kj::Promise<void> ServantPort::whenTaken(std::uint16_t command) {
  if (channel_->info.commands[command].latest) return kj::READY_NOW;
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
  pumpReplies();
  pumpCredits();
  pumpTally();
  pumpEvents();
  pumpRow();
  pumpStatus();
}

void ServantPort::pumpReplies() {
  while (const ReplyRecord* const reply = channel_->nextReply()) {
    for (PendingCall& call : calls_) {
      if (call.number != reply->call || call.done.get() == nullptr) continue;
      if (reply->error == Errc{}) {
        answer(call, *reply);
      } else {
        call.done->reject(failureOf(call, reply->error));
      }
      call = PendingCall{};
    }
    channel_->popReply();
  }
}

void ServantPort::answer(PendingCall& pending, const ReplyRecord& reply) {
  const CommandCodec& codec = channel_->info.codec().commands[pending.command];
  KJ_IF_MAYBE (call, pending.call) {
    auto out = call->getResults();
    codec.result.encode(reply.result(), out);
    codec.stamp.set(out, toNanoseconds(reply.stamp));
  }
  pending.done->fulfill();
}

// The provider noted what is invalid before it answered. If it answered two calls of one command
// so, both tell what the later had.
kj::Exception ServantPort::failureOf(const PendingCall& call, Errc error) const {
  if (error != Errc::Invalid) return remoteError(error);
  const FieldPath last = channel_->lastInvalid.read();
  const bool isOfThis = last.beginsWith(channel_->info.commands[call.command].name);
  return remoteError(error, isOfThis ? last : FieldPath());
}

void ServantPort::pumpCredits() {
  for (std::uint16_t command = 0; command < taken_.size(); ++command) {
    auto& calls = taken_[command];
    if (calls.empty()) continue;
    for (auto waiting = channel_->commands.waiting(command); calls.size() > waiting;) {
      if (calls.front().get() != nullptr) calls.front()->fulfill();
      calls.pop_front();
    }
  }
}

void ServantPort::pumpTally() {
  KJ_IF_MAYBE (listener, listener_) {
    const Tally tally = channel_->counts->own(ConnectionEnd::Provider);
    if (tallyInFlight_ || tally == tally_) return;
    tally_ = tally;
    tallyInFlight_ = true;
    sending_.add((*listener)
                     ->tallies(tally)
                     .then([this] { return control_.timer().afterDelay(toKj(kTallyPause)); })
                     .then([this] {
                       tallyInFlight_ = false;
                       pumpTally();
                     }));
  }
}

void ServantPort::pumpEvents() {
  KJ_IF_MAYBE (subscriber, subscriber_) {
    while (!answering_ && eventsInFlight_ < kWindow) {
      const rt::EventRecord* record = channel_->events.next();
      if (record == nullptr) return;
      if (wanted(*record)) sendEvent(*subscriber, *record);
      channel_->events.pop();
    }
  }
}

// The value of a latched event may be older than its subscription, for it is a replay.
bool ServantPort::wanted(const rt::EventRecord& record) const {
  if ((channel_->subscribed() >> record.event & 1) == 0) return false;
  return record.stamp >= since_[record.event] || channel_->info.events[record.event].latched;
}

void ServantPort::sendEvent(Subscriber& subscriber, const rt::EventRecord& record) {
  ++eventsInFlight_;
  sending_.add(subscriber.event(record).then([this] { eventSent(); },
                                             [this](kj::Exception&& failure) {
                                               throwIfGone(kj::mv(failure));
                                               channel_->events.countDropped();
                                               eventSent();
                                             }));
}

void ServantPort::eventSent() {
  --eventsInFlight_;
  pumpEvents();
}

void ServantPort::pumpRow() {
  KJ_IF_MAYBE (subscriber, subscriber_) {
    if (columns_ == 0 || rowsInFlight_ == kWindow || channel_->state->rows() == lastRow_) return;
    rt::StateTable::Row row = channel_->state->readRow(rowPointers_);
    lastRow_ = row.sequence;
    row.keep(columns_);
    if (row.any()) sendRow(*subscriber, row);
    releaseRow();
  }
}

void ServantPort::sendRow(Subscriber& subscriber, const rt::StateTable::Row& row) {
  ++rowsInFlight_;
  sending_.add(subscriber.row(row, rowPointers_)
                   .then(
                       [this] {
                         --rowsInFlight_;
                         pumpRow();
                       },
                       [this, row](kj::Exception&& failure) {
                         --rowsInFlight_;
                         const bool tooLarge = errcOf(failure) == Errc::TooLarge;
                         throwIfGone(kj::mv(failure));
                         if (!tooLarge) return pumpRow();
                         rt::StateTable::Row told = row;  // the client learns that much
                         told.tooLarge |= std::exchange(told.valid, 0);
                         KJ_IF_MAYBE (still, subscriber_) sendRow(*still, told);
                       }));
}

void ServantPort::releaseRow() {
  for (unsigned i = 0; i < rowPointers_.size(); ++i) {
    if (rowPointers_[i] != nullptr && channel_->state->isShared(i)) {
      releaseSharedSlot(rowPointers_[i]);
    }
  }
}

void ServantPort::changed(ChannelStatus status) {
  const Errc end = endOfCalls(status);
  if (end == Errc{}) return;
  pumpReplies();  // an answer may have come just before the end
  failAll(end);
}

void ServantPort::failAll(Errc error) {
  for (PendingCall& call : calls_) {
    if (call.done.get() != nullptr) call.done->reject(remoteError(error));
    call = PendingCall{};
  }
  for (auto& calls : taken_) {
    for (auto& call : calls) {
      if (call.get() != nullptr) call->reject(remoteError(error));
    }
    calls.clear();
  }
}

// The subscriber does not answer any more: whoever ends the connection will hear of it elsewhere.
void ServantPort::taskFailed(kj::Exception&&) { subscriber_ = nullptr; }

}  // namespace suture::rpc
