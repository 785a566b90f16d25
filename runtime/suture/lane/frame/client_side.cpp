#include <suture/lane/frame/client_side.h>
#include <suture/rt/counter.h>

#include <cstring>

namespace suture::frame {
// The provider's channel was made with what is subscribed to; the first frame says so once more, so
// that the provider's side hears of this one.
ClientSide::ClientSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                       std::uint32_t number)
    : Connection(std::move(channel), std::move(payloads), number),
      events_(channel_->subscribed()),
      since_(channel_->info.events.size()),
      lent_(channel_->info.commands.size()) {
  channel_->takeJoining();
}

// ---- from the provider

bool ClientSide::take(const Header& header, std::span<std::byte> payload) {
  switch (header.kind) {
    case Kind::Reply: return takeReply(header, payload);
    case Kind::Event: return takeEvent(header, payload);
    case Kind::Row: return takeRow(header, payload);
    case Kind::Taken: return takeCredits(header);
    case Kind::Tally: return takeTally(payload);
    default: return false;
  }
}

void ClientSide::takePart(Kind kind, std::span<const std::byte> payload) {
  if (kind == Kind::Row) payloads_->openRowPart(payload, channel_->clockShift(), *channel_->state);
}

void ClientSide::taken() {
  if (news_) {
    channel_->ends.client->ring();
  } else if (arrival_) {
    channel_->ends.client->ring(rt::RungFor::Arrival);
  }
  arrival_ = news_ = false;
}

// An answer to a call that is no longer known comes too late for anybody.
bool ClientSide::takeReply(const Header& header, std::span<std::byte> payload) {
  const Sent& sent = calls_[header.call % calls_.size()];
  if (header.call == 0 || sent.call != header.call) return true;
  ArrivedValue result{nullptr, static_cast<Errc>(header.error)};
  if (result.error != Errc{}) {
    if (!payload.empty()) return false;
  } else {
    result = payloads_->open({Kind::Reply, sent.command}, payload, channel_->clockShift());
    if (result.slot == nullptr) return false;
  }
  const CommandInfo& command = channel_->info.commands[sent.command];
  const std::uint32_t size = result.error == Errc{} ? command.resultSize : 0;
  const auto copy = [&](std::byte* memory) {
    if (size > 0) std::memcpy(memory, result.slot, size);
    return result.error;
  };
  channel_->reply(header.call, {.size = size}, copy, here(header.stamp));
  arrival_ = true;
  return true;
}

// Drops an event that was emitted for an earlier subscription than the present one.
bool ClientSide::takeEvent(const Header& header, std::span<std::byte> payload) {
  const std::size_t number = placeOf(channel_->info.wireEvents, header.number);
  if (number >= since_.size()) return false;
  if (header.call < since_[number]) return true;
  const EventInfo& event = channel_->info.events[number];
  const auto own = static_cast<std::uint16_t>(number);
  const ArrivedValue value = payloads_->open({Kind::Event, own}, payload, channel_->clockShift());
  if (value.slot == nullptr) return false;
  if (value.error != Errc{} || !channel_->admits(event, value.slot)) {
    channel_->events.countDropped();
    return true;
  }
  channel_->events.push(own, here(header.stamp), {value.slot, event.payloadSize});
  arrival_ = true;
  return true;
}

bool ClientSide::takeRow(const Header& header, std::span<std::byte> payload) {
  auto row = payloads_->openRow(payload, channel_->clockShift(), *channel_->state);
  if (!row) return false;
  row->columns.keep(columns_);
  if (!row->columns.any()) return true;
  channel_->state->publish(here(header.stamp), row->columns, row->values);
  news_ = news_ || channel_->wantsRows.isUp(std::memory_order_relaxed);
  return true;
}

bool ClientSide::takeCredits(const Header& header) {
  if (header.number >= lent_.size() || header.call > lent_[header.number]) return false;
  lent_[header.number] -= header.call;
  for (std::uint32_t i = 0; i < header.call; ++i) channel_->commands.returnCredit(header.number);
  return true;
}

bool ClientSide::takeTally(std::span<const std::byte> payload) {
  Tally tally;
  if (payload.size() != sizeof(tally)) return false;
  std::memcpy(&tally, payload.data(), sizeof(tally));
  channel_->counts->told.store(tally);
  return true;
}

// ---- to the provider

bool ClientSide::give() {
  giveSubscription();
  giveCommands();
  return false;
}

void ClientSide::giveSubscription() {
  const rt::ColumnSet columns = channel_->state->demand();
  const bool known = subscription_ != 0 && columns == columns_ && channel_->subscribed() == events_;
  if ((known && !channel_->joining()) || !hasRoom()) return;
  ++subscription_;
  const EventSet joining = channel_->takeJoining();
  const EventSet events = channel_->subscribed();  // after it: has all that join
  for (std::size_t i = 0; i < since_.size(); ++i) {
    if (joining >> i & 1) since_[i] = subscription_;
  }
  events_ = events;
  columns_ = columns;
  const InterfaceInfo& contract = channel_->info;
  const Subscription content{.events = toWireNumbers(contract.wireEvents, events),
                             .joining = toWireNumbers(contract.wireEvents, joining),
                             .columns = toWireNumbers(contract.wireColumns, columns)};
  send({.kind = Kind::Subscribe, .call = subscription_}, std::as_bytes(std::span(&content, 1)));
}

// Without room, commands stay with the client, where its credits bound them or newer ones replace
// them.
void ClientSide::giveCommands() {
  rt::Mailbox& commands = channel_->commands;
  if (!hasRoom() || !commands.pending()) return;
  commands.fixCut();
  giveSubscription();  // ahead of commands that were sent later
  while (hasRoom()) {
    const rt::CommandRecord* const record = commands.next();
    if (record == nullptr) return;
    giveCommand(*record);
  }
}

void ClientSide::giveCommand(const rt::CommandRecord& record) {
  const std::uint16_t number = record.command;
  const CommandInfo& command = channel_->info.commands[number];
  if (record.call != 0 && !channel_->claimCall(record.call)) {
    channel_->replyError(record.call, Errc::Cancelled);
    channel_->ends.client->ring(rt::RungFor::Arrival);
    rt::increment(channel_->commands.counters.cancelled);
    channel_->commands.pop();
    return channel_->commands.returnCredit(number);
  }
  if (record.call != 0) calls_[record.call % calls_.size()] = {record.call, number};
  // A newest-wins command without an answer uses no credit.
  if (!command.latest || record.call != 0) ++lent_[number];
  sendValue({.kind = Kind::Command,
             .number = number,
             .call = record.call,
             .stamp = toNanoseconds(record.stamp)},
            payloads_->pack({Kind::Command, number}, record.arguments()));
}

void ClientSide::letGo(Kind) { channel_->commands.pop(); }

}  // namespace suture::frame
