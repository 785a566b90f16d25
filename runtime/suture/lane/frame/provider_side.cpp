#include <suture/lane/frame/provider_side.h>
#include <suture/rt/counter.h>

#include <cstring>
#include <utility>

namespace suture::frame {

ProviderSide::ProviderSide(std::shared_ptr<Channel> channel, std::uint32_t number)
    : Connection(std::move(channel), number),
      waiting_(channel_->info.commands.size()),
      since_(channel_->info.events.size(), now()),
      slots_(channel_->state->columns()),
      wantedSlots_(channel_->state->columns()) {
  for (const CommandInfo& one : channel_->info.commands) {
    if (one.column >= 0)
      slots_[static_cast<unsigned>(one.column)].resize(wordBytes(one.resultSize) / 8);
  }
  // This also tells when commands have been taken, if a provider publishes no rows.
  channel_->wantsRows.raise();
}

// ---- from the client

bool ProviderSide::take(const Header& header, std::span<std::byte> payload) {
  heard_ = true;
  switch (header.kind) {
    case Kind::Command: return takeCommand(header, payload);
    case Kind::Subscribe: return takeSubscription(header, payload);
    default: return false;
  }
}

void ProviderSide::taken() {
  if (std::exchange(work_, false)) channel_->ends.provider->ring();
}

bool ProviderSide::takeCommand(const Header& header, std::span<std::byte> payload) {
  if (header.number >= waiting_.size()) return false;
  const CommandInfo& command = channel_->info.commands[header.number];
  if (payload.size() != command.argumentsSize) return false;
  const bool usesCredit = !command.latest || header.call != 0;
  if (usesCredit && waiting_[header.number] == command.depth) return false;
  if (usesCredit) ++waiting_[header.number];
  bringHere(command.shiftArguments, payload.data());
  const Errc error = post(header, payload);
  if (error != Errc{}) return refuse(header, error);
  work_ = true;
  return true;
}

bool ProviderSide::refuse(const Header& header, Errc error) {
  rt::increment(channel_->counts->turnedAway);
  if (header.call == 0) return true;
  if (refusedCallCount_ == refusedCalls_.size()) return false;
  refusedCalls_[refusedCallCount_++] = {header.call, error};
  return true;
}

Errc ProviderSide::post(const Header& header, std::span<const std::byte> payload) {
  const CommandInfo& command = channel_->info.commands[header.number];
  const Errc error = errorOf(channel_->status.load(std::memory_order_acquire));
  if (error != Errc{}) return error;
  if (readOnly_ && !command.reads()) return Errc::NotPermitted;
  const auto slot = channel_->commands.claim(header.number, here(header.stamp), header.call);
  if (!slot) return slot.error();
  if (!payload.empty()) std::memcpy(*slot, payload.data(), payload.size());
  if (!channel_->admits(command, *slot)) {
    channel_->commands.abandon();
    return Errc::Invalid;
  }
  channel_->commands.commit();
  return Errc{};
}

bool ProviderSide::takeSubscription(const Header& header, std::span<const std::byte> payload) {
  Subscription wanted;
  if (payload.size() != sizeof(wanted)) return false;
  std::memcpy(&wanted, payload.data(), sizeof(wanted));
  subscription_ = header.call;
  for (std::size_t i = 0; i < since_.size(); ++i) {
    if (wanted.joining >> i & 1) since_[i] = now();
  }
  channel_->subscribe(wanted.events, wanted.joining & wanted.events);
  columns_ = 0;
  lastRow_ = 0;
  for (unsigned i = 0; i < slots_.size(); ++i) {
    const bool read = (wanted.columns >> i & 1) != 0 && !slots_[i].empty();
    wantedSlots_[i] = read ? reinterpret_cast<std::byte*>(slots_[i].data()) : nullptr;
    if (read) columns_ |= rt::ColumnSet{1} << i;
  }
  channel_->state->askAll(columns_);
  work_ = true;
  return true;
}

// ---- to the client

void ProviderSide::give() {
  if (!heard_) return;
  giveReplies();
  giveRefusals();
  giveCredits();
  giveTally();
  giveEvents();
  giveRow();
}

void ProviderSide::giveReplies() {
  while (hasRoom()) {
    const ReplyRecord* const reply = channel_->nextReply();
    if (reply == nullptr) return;
    const bool value = reply->error == Errc{};
    const std::size_t size = value ? channel_->replies.frontSize() - sizeof(ReplyRecord) : 0;
    send({.kind = Kind::Reply,
          .error = static_cast<std::uint8_t>(reply->error),
          .call = reply->call,
          .stamp = toNanoseconds(reply->stamp)},
         {reply->result(), size});
    channel_->popReply();
  }
}

void ProviderSide::giveRefusals() {
  while (refusedCallCount_ > 0 && hasRoom()) {
    const RefusedCall& one = refusedCalls_[--refusedCallCount_];
    send({.kind = Kind::Reply, .error = static_cast<std::uint8_t>(one.error), .call = one.call});
  }
}

void ProviderSide::giveTally() {
  const Tally tally = channel_->counts->own(ConnectionEnd::Provider);
  if (tally == tally_ || !hasRoom()) return;
  tally_ = tally;
  send({.kind = Kind::Tally}, std::as_bytes(std::span(&tally_, 1)));
}

void ProviderSide::giveCredits() {
  for (std::uint16_t command = 0; command < waiting_.size(); ++command) {
    if (waiting_[command] == 0) continue;
    const std::uint32_t there = channel_->commands.waiting(command);
    if (there >= waiting_[command]) continue;
    if (!hasRoom()) return;
    send({.kind = Kind::Taken, .number = command, .call = waiting_[command] - there});
    waiting_[command] = there;
  }
}

void ProviderSide::giveEvents() {
  while (hasRoom()) {
    const rt::EventRecord* const record = channel_->events.next();
    if (record == nullptr) return;
    if (wanted(*record)) {
      send({.kind = Kind::Event,
            .number = record->event,
            .call = subscription_,
            .stamp = toNanoseconds(record->stamp)},
           {record->payload(), channel_->info.events[record->event].payloadSize});
    }
    channel_->events.pop();
  }
}

// The value of a latched event may be older than its subscription, for it is a replay.
bool ProviderSide::wanted(const rt::EventRecord& record) const {
  if ((channel_->subscribed() >> record.event & 1) == 0) return false;
  return record.stamp >= since_[record.event] || channel_->info.events[record.event].latched;
}

void ProviderSide::giveRow() {
  rt::StateTable& state = *channel_->state;
  if (columns_ == 0 || !hasRoom() || state.rows() == lastRow_) return;
  rt::StateTable::Row row = state.readRow(wantedSlots_);
  lastRow_ = row.sequence;
  row.keep(columns_);
  if (row.any()) sendRow(row);
}

void ProviderSide::sendRow(const rt::StateTable::Row& row) {
  const rt::RowColumns& columns = row;
  std::size_t size = sizeof(columns);
  for (unsigned i = 0; i < slots_.size(); ++i) {
    if (row.hasValue(i)) size += slots_[i].size() * sizeof(std::uint64_t);
  }
  std::byte* memory = begin({.kind = Kind::Row, .stamp = toNanoseconds(row.stamp)}, size);
  const auto put = [&memory](const void* bytes, std::size_t count) {
    std::memcpy(memory, bytes, count);
    memory += count;
  };
  put(&columns, sizeof(columns));
  for (unsigned i = 0; i < slots_.size(); ++i) {
    if (row.hasValue(i)) put(slots_[i].data(), slots_[i].size() * sizeof(std::uint64_t));
  }
  finish();
}

}  // namespace suture::frame
