#include <suture/lane/delay/delayed_connection.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace suture {
namespace {

// Two seconds of what comes at 1 kHz.
constexpr std::size_t kUnderWay = 2048;

// A message may come so long after others and is still awaited, if nothing newer comes.
constexpr Duration kMarkPeriod = std::chrono::milliseconds(50);

// The kinds of messages of a connection: each meets faults of its own.
enum Stream : std::uint64_t { kCommands, kAnswers, kEvents, kRows };

struct RowRecord {
  Time stamp;
  rt::RowColumns columns;
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
  std::size_t size = 0;
  for (const EventInfo& one : info.events) size = std::max<std::size_t>(size, one.payloadSize);
  return sizeof(rt::EventRecord) + size;
}

std::size_t largestRow(const rt::StateTable& state) {
  std::size_t size = sizeof(RowRecord);
  for (unsigned i = 0; i < state.columns(); ++i) size += wordBytes(state.columnSize(i));
  return size;
}

}  // namespace

DelayedConnection::DelayedConnection(std::shared_ptr<Channel> near, std::shared_ptr<Channel> far,
                                     const ConnectionDelay& delay)
    : near_(std::move(near)),
      far_(std::move(far)),
      delay_(delay),
      commands_(largestCommand(near_->info), kUnderWay, delay.faults, kCommands, near_->delivery),
      // There may be more answers than calls, since there are duplicates and marks too.
      answers_(largestAnswer(near_->info), std::size_t{8} * Channel::kMaxCalls, delay.faults,
               kAnswers, near_->delivery),
      events_(largestEvent(near_->info), kUnderWay, delay.faults, kEvents, near_->delivery),
      rows_(largestRow(*near_->state), kUnderWay, delay.faults, kRows, near_->delivery),
      statuses_(sizeof(ChannelStatus), kUnderWay),
      underWay_(near_->info.commands.size()),
      lent_(near_->info.commands.size()),
      nextRow_(std::max<std::uint64_t>(far_->state->rows(), 1)) {
  for (unsigned i = 0; i < near_->state->columns(); ++i) {
    slots_.emplace_back(wordBytes(near_->state->columnSize(i)) / 8);
    slotPointers_.push_back(reinterpret_cast<std::byte*>(slots_.back().data()));
  }
  far_->wantsRows.raise();
  near_->takeJoining();  // as the far channel, it was made with what is subscribed to
}

void DelayedConnection::pump(Time now) {
  passDemandOn();
  takeCommands();
  passSubscriptionsOn();  // ahead of commands that were sent later
  deliverCommands(now);
  returnCredits();
  takeAnswers();
  takeEvents();
  takeRows();
  takeStatus();
  sendMarks(now);
  deliverAnswers(now);
  deliverEvents(now);
  deliverRows(now);
  deliverStatus(now);
  countBytes();
  countCommands();
}

Time DelayedConnection::due() {
  const Time marks = expectsMarks() ? nextMarks_ : Time::max();
  return std::min(
      {commands_.next(), answers_.next(), events_.next(), rows_.next(), statuses_.next(), marks});
}

bool DelayedConnection::awaitsCredits() const {
  return std::any_of(lent_.begin(), lent_.end(), [](std::uint32_t count) { return count > 0; });
}

bool DelayedConnection::over() const {
  return near_->status.load(std::memory_order_acquire) == ChannelStatus::Closed;
}

void DelayedConnection::end() {
  near_->tell(ChannelStatus::Lost);
  far_->status = ChannelStatus::Closed;
  far_->ends.provider->ring();
}

// A newest-wins command without an answer travels in its cell.
bool DelayedConnection::usesCredit(const rt::CommandRecord& record) const {
  return !near_->info.commands[record.command].latest || record.call != 0;
}

// Without room, commands stay with the client, where its credits bound them or newer ones replace
// them.
void DelayedConnection::takeCommands() {
  rt::Mailbox& commands = near_->commands;
  if (!commands.pending()) return;
  commands.fixCut();
  while (commands_.hasRoom()) {
    const rt::CommandRecord* record = commands.next();
    if (record == nullptr) return;
    const std::size_t size = near_->info.commands[record->command].argumentsSize;
    std::byte* memory = commands_.claim(record->stamp + delay_.commands, sizeof(*record) + size);
    std::memcpy(memory, record, sizeof(*record) + size);
    commands_.commit();
    if (record->call != 0) calls_.sent(record->call, commands_.sent());
    if (usesCredit(*record)) {
      outstanding_.push_back({commands_.sent(), record->command});
      ++underWay_[record->command];
      ++lent_[record->command];
    }
    commands.pop();
  }
}

// Marks settle what has been lost, so there are none where nothing can be.
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

void DelayedConnection::deliverCommands(Time now) {
  bool any = false;
  while (const std::byte* memory = commands_.due(now)) {
    if (!commands_.isMark()) {
      deliver(*reinterpret_cast<const rt::CommandRecord*>(memory));
      ++delivered_;
      any = true;
    }
    commands_.pop();
  }
  if (any) far_->ends.provider->ring();
}

void DelayedConnection::deliver(const rt::CommandRecord& record) {
  if (record.call != 0 && !near_->claimCall(record.call)) {
    rt::increment(near_->commands.counters.cancelled);
    refuse(record.call, Errc::Cancelled);
    return;
  }
  const auto slot = far_->commands.claim(record.command, record.stamp, record.call);
  if (!slot) {
    // There is no room only if the provider's end gives no credit back: nobody serves it any more.
    rt::increment(near_->commands.counters.refused);
    if (record.call != 0) refuse(record.call, slot.error());
    return;
  }
  if (record.call != 0) calls_.given(record.call);
  std::memcpy(*slot, record.arguments(), near_->info.commands[record.command].argumentsSize);
  far_->countSent(far_->commands.commit());
}

void DelayedConnection::refuse(std::uint32_t call, Errc error) {
  if (!calls_.end(call)) return;
  near_->replyError(call, error);
  near_->ends.client->ring(rt::RungFor::Arrival);
}

// Lost commands give their credits back like those that have arrived: neither arrive any more.
void DelayedConnection::returnCredits() {
  while (!outstanding_.empty() && outstanding_.front().sequence <= commands_.reached()) {
    --underWay_[outstanding_.front().command];
    outstanding_.pop_front();
  }
  for (std::uint16_t command = 0; command < lent_.size(); ++command) {
    const std::uint32_t kept = underWay_[command] + far_->commands.waiting(command);
    for (; lent_[command] > kept; --lent_[command]) near_->commands.returnCredit(command);
  }
}

void DelayedConnection::passDemandOn() {
  const rt::ColumnSet demand = near_->state->demand();
  if (demand == asked_) return;
  bool first = false;
  for (unsigned i = 0; i < near_->state->columns(); ++i) {
    if ((demand & ~asked_) >> i & 1) first = far_->state->ask(i) || first;
  }
  asked_ = demand;
  if (first) far_->ends.provider->ring();
}

void DelayedConnection::passSubscriptionsOn() {
  const EventSet joining = near_->takeJoining();
  if (joining == 0 && near_->subscribed() == far_->subscribed()) return;
  far_->subscribe(near_->subscribed(), joining);
  far_->ends.provider->ring();
}

void DelayedConnection::takeAnswers() {
  while (const std::byte* answer = far_->replies.front()) {
    const std::size_t size = far_->replies.frontSize();
    std::byte* memory = answers_.claim(now() + delay_.answers, size);
    if (memory == nullptr) return;
    std::memcpy(memory, answer, size);
    answers_.commit();
    calls_.answered(reinterpret_cast<const ReplyRecord*>(answer)->call);
    far_->countReceived(rt::SpscRing::recordSize(size));
    far_->replies.pop();
  }
}

void DelayedConnection::deliverAnswers(Time now) {
  bool any = false;
  while (const std::byte* memory = answers_.due(now)) {
    if (answers_.isMark()) {
      settleCalls(*reinterpret_cast<const CallsMark*>(memory));
    } else {
      deliverAnswer(*reinterpret_cast<const ReplyRecord*>(memory));
      any = true;
    }
    answers_.pop();
  }
  if (any) near_->ends.client->ring(rt::RungFor::Arrival);
}

void DelayedConnection::deliverAnswer(const ReplyRecord& answer) {
  if (!calls_.end(answer.call)) return;
  const auto size = static_cast<std::uint32_t>(answers_.size() - sizeof(ReplyRecord));
  const auto copy = [&](std::byte* result) {
    std::memcpy(result, answer.result(), size);
    return answer.error;
  };
  near_->reply(answer.call, {.size = size}, copy, answer.stamp);
}

// The client's end cannot tell a command that was lost from an answer that was.
void DelayedConnection::settleCalls(const CallsMark& mark) {
  calls_.settle(mark, [this](std::uint32_t call) {
    near_->replyError(call, Errc::OutcomeUnknown);
    near_->ends.client->ring(rt::RungFor::Arrival);
  });
}

// Without room, events stay in the provider's queue, which drops and counts as without delay.
void DelayedConnection::takeEvents() {
  while (events_.hasRoom()) {
    const rt::EventRecord* record = far_->events.next();
    if (record == nullptr) return;
    const std::size_t size = near_->info.events[record->event].payloadSize;
    std::byte* memory = events_.claim(record->stamp + delay_.answers, sizeof(*record) + size);
    std::memcpy(memory, record, sizeof(*record) + size);
    events_.commit();
    far_->countReceived(sizeof(*record) + size);
    far_->events.pop();
  }
}

void DelayedConnection::deliverEvents(Time now) {
  bool any = false;
  while (const std::byte* memory = events_.due(now)) {
    const auto& record = *reinterpret_cast<const rt::EventRecord*>(memory);
    const std::size_t size = near_->info.events[record.event].payloadSize;
    near_->events.push(record.event, record.stamp, std::span(record.payload(), size));
    events_.pop();
    any = true;
  }
  if (any) near_->ends.client->ring(rt::RungFor::Arrival);
}

void DelayedConnection::takeRows() {
  const std::uint64_t newest = far_->state->rows(), capacity = far_->state->capacity();
  if (newest > capacity) nextRow_ = std::max(nextRow_, newest - capacity + 1);  // of those kept
  for (; nextRow_ <= newest; ++nextRow_) {
    rt::StateTable::Row row = far_->state->readRowNumber(nextRow_, slotPointers_);
    if (row.sequence == 0) continue;
    far_->countReceived(far_->state->rowBytes());
    row.keep(asked_);
    if (row.any()) keepRow(row, now() + delay_.answers);
  }
}

// Without room a row is left out: a state thins out where a queue would overflow.
void DelayedConnection::keepRow(const rt::StateTable::Row& row, Time due) {
  std::byte* memory = rows_.claim(due, largestRow(*near_->state));
  if (memory == nullptr) return;
  new (memory) RowRecord{row.stamp, row};
  memory += sizeof(RowRecord);
  for (unsigned i = 0; i < slotPointers_.size(); ++i) {
    if (row.hasValue(i)) std::memcpy(memory, slotPointers_[i], near_->state->columnSize(i));
    memory += wordBytes(near_->state->columnSize(i));
  }
  rows_.commit();
}

void DelayedConnection::deliverRows(Time now) {
  bool any = false;
  while (const std::byte* memory = rows_.due(now)) {
    const auto& row = *reinterpret_cast<const RowRecord*>(memory);
    memory += sizeof(RowRecord);
    for (unsigned i = 0; i < slotPointers_.size(); ++i) {
      const std::uint32_t size = near_->state->columnSize(i);
      if (row.columns.hasValue(i)) std::memcpy(near_->state->draft(i), memory, size);
      memory += wordBytes(size);
    }
    near_->state->publish(row.stamp, row.columns);
    rows_.pop();
    any = true;
  }
  if (any && near_->wantsRows.isUp(std::memory_order_relaxed)) near_->ends.client->ring();
}

// Delays a status as answers are, so that it comes behind those that came before it.
void DelayedConnection::takeStatus() {
  const ChannelStatus status = far_->status.load(std::memory_order_acquire);
  if (status == status_) return;
  std::byte* memory = statuses_.claim(now() + delay_.answers, sizeof(status));
  if (memory == nullptr) return;
  new (memory) ChannelStatus(status);
  statuses_.commit();
  status_ = status;
}

void DelayedConnection::deliverStatus(Time now) {
  while (const std::byte* memory = statuses_.due(now)) {
    const auto status = *reinterpret_cast<const ChannelStatus*>(memory);
    statuses_.pop();
    near_->tell(status);
  }
}

// Adds what was told from beyond, since the provider's end may be another lane's client.
void DelayedConnection::countCommands() {
  const ChannelCounts& beyond = *far_->counts;
  constexpr auto kEnd = ConnectionEnd::Client;
  near_->counts->told.store(beyond.own(kEnd) + beyond.heard(kEnd));
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
