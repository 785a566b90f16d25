#include <suture/component/channel/credit.h>
#include <suture/lane/delay/delayed_connection.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace suture {
namespace {

// Holds two seconds of messages at 1 kHz.
constexpr std::size_t kUnderWay = 2048;

// A message that comes this much later than others is still awaited, if nothing newer comes.
constexpr Duration kMarkPeriod = std::chrono::milliseconds(50);

// These are the kinds of messages of a connection; each has its own faults.
enum Stream : std::uint64_t { kCommands, kAnswers, kEvents, kRows };

struct EventMessage {
  std::uint64_t subscription;
  rt::EventRecord record;  // the payload follows

  static std::size_t size(const EventInfo& event) {
    return sizeof(EventMessage) + event.payloadSize;
  }
};

struct RowMessage {
  Time stamp;
  rt::RowColumns columns;  // the values follow, each at a word
};

std::size_t largestCommand(const InterfaceInfo& info) {
  std::size_t size = 0;
  for (const CommandInfo& one : info.commands)
    size = std::max<std::size_t>(size, one.argumentsSize);
  return sizeof(rt::CommandRecord) + size;
}

std::size_t largestAnswer(const InterfaceInfo& info) {
  std::size_t size = 0;
  for (const CommandInfo& one : info.commands) size = std::max<std::size_t>(size, one.resultSize);
  return std::max(sizeof(ReplyRecord) + size, sizeof(CallsMark));
}

std::size_t largestEvent(const InterfaceInfo& info) {
  std::size_t size = sizeof(EventMessage);
  for (const EventInfo& one : info.events) size = std::max(size, EventMessage::size(one));
  return size;
}

std::size_t largestRow(const rt::StateTable& state) {
  std::size_t size = sizeof(RowMessage);
  for (unsigned i = 0; i < state.columns(); ++i) size += wordBytes(state.columnSize(i));
  return size;
}

}  // namespace

DelayedConnection::DelayedConnection(std::shared_ptr<Channel> near, std::shared_ptr<Channel> far,
                                     const ConnectionDelay& delay)
    : near_(std::move(near)),
      far_(std::move(far)),
      delay_(delay),
      commands_(largestCommand(near_->info), kUnderWay, delay.faults, kCommands,
                near_->client.delivery),
      // There may be more answers than calls, since there are duplicates and marks too.
      answers_(largestAnswer(near_->info), std::size_t{8} * Channel::kMaxCalls, delay.faults,
               kAnswers, near_->client.delivery),
      events_(largestEvent(near_->info), kUnderWay, delay.faults, kEvents, near_->client.delivery),
      rows_(largestRow(*near_->state), kUnderWay, delay.faults, kRows, near_->client.delivery),
      statuses_(sizeof(ChannelStatus), kUnderWay),
      nextRow_(std::max<std::uint64_t>(far_->state->rows(), 1)),
      row_(near_->info),
      values_(near_->state->columns()),
      client_(*near_, *this),
      provider_(*far_, *this) {}

// Delivers first, to make room for what it takes.
void DelayedConnection::pump(Time now) {
  deliverCommands(now);
  deliverAnswers(now);
  deliverEvents(now);
  deliverRows(now);
  client_.ringClient();
  deliverStatus(now);
  client_.give();
  provider_.ringProvider();
  provider_.give();
  client_.ringClient();  // for credits
  takeStatus();
  sendMarks(now);
  countBytes();
  countCommands();
}

Time DelayedConnection::due() {
  const Time marks = expectsMarks() ? nextMarks_ : Time::max();
  return std::min(
      {commands_.next(), answers_.next(), events_.next(), rows_.next(), statuses_.next(), marks});
}

bool DelayedConnection::over() const {
  return near_->status.load(std::memory_order_acquire) == ChannelStatus::Closed;
}

void DelayedConnection::end() {
  near_->tell(ChannelStatus::Lost);
  far_->status = ChannelStatus::Closed;
  far_->ends.provider->ring();
}

// ---- from the client

void DelayedConnection::send(const Interest& interest) { provider_.subscribe(interest); }

void DelayedConnection::send(const rt::CommandRecord& record) {
  const CommandInfo& command = near_->info.commands[record.command];
  const std::size_t size = sizeof(record) + command.argumentsSize;
  std::memcpy(commands_.claim(record.stamp + delay_.commands, size), &record, size);
  commands_.commit();
  if (record.call != 0) calls_.sent(record.call, commands_.sent());
  if (usesCredit(command, record.call)) outstanding_.push_back({commands_.sent(), record.command});
  client_.commandSent();
}

void DelayedConnection::deliverCommands(Time now) {
  while (const std::byte* memory = commands_.due(now)) {
    if (commands_.isMark()) {
      giveUp(commands_.reached());
    } else {
      giveUp(commands_.reached() - 1);
      deliver(*reinterpret_cast<const rt::CommandRecord*>(memory));
    }
    commands_.pop();
  }
}

void DelayedConnection::deliver(const rt::CommandRecord& record) {
  // A command that reaches a connection which is over is lost: no one has refused it.
  const ChannelStatus beyond = far_->status.load(std::memory_order_acquire);
  if (isOver(beyond)) {
    giveUp(commands_.reached());
    return client_.replyError(record.call, errorOf(beyond));
  }
  ++delivered_;
  const CommandInfo& command = near_->info.commands[record.command];
  const auto copy = [&](std::byte* arguments) {
    std::memcpy(arguments, record.arguments(), command.argumentsSize);
    return Errc{};
  };
  const Errc error = provider_.post(record.command, record.stamp, record.call, copy).error;
  if (usesCredit(command, record.call)) {
    outstanding_.pop_front();
    provider_.lend(record.command);
  }
  if (error != Errc{}) {
    rt::increment(near_->commands.counters.refused);
    client_.replyError(record.call, error);
  } else if (record.call != 0) {
    calls_.given(record.call);
  }
}

// Commands up to this number that have not arrived are lost, so they give their credits back.
void DelayedConnection::giveUp(std::uint64_t sequence) {
  for (; !outstanding_.empty() && outstanding_.front().sequence <= sequence;
       outstanding_.pop_front()) {
    client_.credits(outstanding_.front().command, 1);
  }
}

// ---- from the provider

// If there is no room, answers and events stay in the provider's queues, which drop and count them
// as on a connection without a delay. countCommands() tells the client of its commands.
bool DelayedConnection::hasRoom(Message message) const {
  switch (message) {
    case Message::Reply: return answers_.hasRoom();
    case Message::Event: return events_.hasRoom();
    case Message::Tally: return false;
    case Message::Credits:
    case Message::Row: return true;
  }
  return false;
}

void DelayedConnection::send(const ReplyRecord& reply) {
  const std::size_t size = far_->replies.frontSize();
  far_->countReceived(rt::SpscRing::recordSize(size));
  const std::size_t kept = std::min(size, largestAnswer(near_->info));
  std::memcpy(answers_.claim(now() + delay_.answers, kept), &reply, kept);
  answers_.commit();
  calls_.answered(reply.call);
  provider_.replySent();
}

void DelayedConnection::sendCredits(std::uint16_t command, std::uint32_t count) {
  client_.credits(command, count);
}

void DelayedConnection::send(const rt::EventRecord& event, std::uint32_t subscription) {
  const std::size_t payload = near_->info.events[event.event].payloadSize;
  std::byte* const memory =
      events_.claim(event.stamp + delay_.answers, sizeof(EventMessage) + payload);
  auto* const message = new (memory) EventMessage{subscription, event};
  std::memcpy(message + 1, event.payload(), payload);
  events_.commit();
  far_->countReceived(sizeof(event) + payload);
  provider_.eventSent();
}

bool DelayedConnection::sendRow(rt::ColumnSet columns, std::uint64_t& last) {
  const std::uint64_t newest = far_->state->rows(), capacity = far_->state->capacity();
  if (newest == last) return false;
  if (last == 0) nextRow_ = std::min(nextRow_, newest);  // its columns may be others now
  // The provider keeps no older rows.
  if (newest > capacity) nextRow_ = std::max(nextRow_, newest - capacity + 1);
  for (; nextRow_ <= newest; ++nextRow_) {
    rt::StateTable::Row row = far_->state->readRowNumber(nextRow_, row_.of(columns));
    if (row.sequence == 0) continue;
    far_->countReceived(far_->state->rowBytes());
    row.keep(columns);
    if (row.any()) keepRow(row, now() + delay_.answers);
  }
  last = newest;
  return false;
}

// If there is no room, the row is left out: rows become fewer where a queue would overflow.
void DelayedConnection::keepRow(const rt::StateTable::Row& row, Time due) {
  std::byte* memory = rows_.claim(due, largestRow(*near_->state));
  if (memory == nullptr) return;
  new (memory) RowMessage{row.stamp, row};
  memory += sizeof(RowMessage);
  const auto slots = row_.slots();
  for (unsigned i = 0; i < slots.size(); ++i) {
    if (row.hasValue(i)) std::memcpy(memory, slots[i], row_.sizeOf(i));
    memory += wordBytes(row_.sizeOf(i));
  }
  rows_.commit();
}

// Takes a fault even if the provider was restarted before this thread looked.
void DelayedConnection::takeStatus() {
  const std::uint32_t faults = far_->faults.load(std::memory_order_acquire);
  const ChannelStatus status = far_->status.load(std::memory_order_acquire);
  if (faults != faultsTaken_) {
    if (!takeStatus(ChannelStatus::Faulted)) return;
    faultsTaken_ = faults;
  }
  takeStatus(status);
}

// Delays a status as answers are, so that it comes behind those that came before it.
bool DelayedConnection::takeStatus(ChannelStatus status) {
  if (status == status_) return true;
  std::byte* memory = statuses_.claim(now() + delay_.answers, sizeof(status));
  if (memory == nullptr) return false;
  new (memory) ChannelStatus(status);
  statuses_.commit();
  status_ = status;
  return true;
}

void DelayedConnection::deliverAnswers(Time now) {
  while (const std::byte* memory = answers_.due(now)) {
    if (answers_.isMark()) {
      settleCalls(*reinterpret_cast<const CallsMark*>(memory));
    } else {
      deliverAnswer(*reinterpret_cast<const ReplyRecord*>(memory));
    }
    answers_.pop();
  }
}

void DelayedConnection::deliverAnswer(const ReplyRecord& answer) {
  const auto command = client_.commandOf(answer.call);
  if (!command) return;
  const std::size_t size = near_->info.commands[*command].resultSize;
  Errc error = answer.error;
  // A foreign provider may claim that its answer has any size.
  if (error == Errc{} && answers_.size() < sizeof(answer) + size) error = Errc::Invalid;
  client_.reply(answer.call, answer.stamp, error, {answer.result(), size});
}

void DelayedConnection::deliverEvents(Time now) {
  while (const std::byte* memory = events_.due(now)) {
    const auto& message = *reinterpret_cast<const EventMessage*>(memory);
    const rt::EventRecord& event = message.record;
    const auto subscription = static_cast<std::uint32_t>(message.subscription);
    if (!client_.event(event.event, subscription, event.stamp, memory + sizeof(message))) {
      near_->events.countDropped();
    }
    events_.pop();
  }
}

void DelayedConnection::deliverRows(Time now) {
  while (const std::byte* memory = rows_.due(now)) {
    const auto& message = *reinterpret_cast<const RowMessage*>(memory);
    memory += sizeof(RowMessage);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      values_[i] = {.bytes = memory};
      memory += wordBytes(row_.sizeOf(i));
    }
    client_.row(message.stamp, message.columns, values_);
    rows_.pop();
  }
}

void DelayedConnection::deliverStatus(Time now) {
  while (const std::byte* memory = statuses_.due(now)) {
    const auto status = *reinterpret_cast<const ChannelStatus*>(memory);
    statuses_.pop();
    near_->tell(status);
  }
}

// ---- losses

// Marks settle what has been lost, so there are none where nothing can be lost.
bool DelayedConnection::expectsMarks() const {
  return delay_.faults.any() && (!outstanding_.empty() || calls_.any());
}

void DelayedConnection::sendMarks(Time now) {
  if (!expectsMarks() || now < nextMarks_) return;
  nextMarks_ = now + kMarkPeriod;
  if (commands_.claimMark(now + delay_.commands, 0, commandsSent_) != nullptr) commands_.commit();
  commandsSent_ = commands_.sent();
  std::byte* memory = answers_.claimMark(now + delay_.answers, sizeof(CallsMark), answersSent_);
  if (memory != nullptr) {
    new (memory) CallsMark(callsMark_);
    answers_.commit();
  }
  answersSent_ = answers_.sent();
  callsMark_ = calls_.mark(commands_.reached());
}

// The client's end cannot tell a lost command from a lost answer.
void DelayedConnection::settleCalls(const CallsMark& mark) {
  calls_.settle(mark,
                [this](std::uint32_t call) { client_.replyError(call, Errc::OutcomeUnknown); });
}

// If the far end is another lane's client, only what that has heard is the provider's word; what it
// counts itself was decided in this process.
void DelayedConnection::countCommands() {
  const ChannelCounts& beyond = *far_->counts;
  const ConnectionEnd end = far_->ends.components;
  if (end == ConnectionEnd::Provider) {
    near_->counts->told.store(beyond.own(end));
  } else {
    near_->counts->decided.store(beyond.own(end));
    near_->counts->told.store(beyond.heard(end));
  }
  near_->counts->lost.store(commands_.reached() - delivered_ + rt::count(beyond.lost),
                            std::memory_order_relaxed);
}

void DelayedConnection::countBytes() {
  near_->bytesSent.store(far_->bytesSent.load(std::memory_order_relaxed),
                         std::memory_order_relaxed);
  near_->bytesReceived.store(far_->bytesReceived.load(std::memory_order_relaxed),
                             std::memory_order_relaxed);
}

}  // namespace suture
