#include <suture/base/slots/used_parts.h>
#include <suture/component/channel/credit.h>
#include <suture/lane/carrier/client_carrier.h>
#include <suture/rt/counter.h>

#include <cstring>

namespace suture {

// The first subscription repeats what the provider's channel was made with, so that the lane hears
// of this end.
ClientCarrier::ClientCarrier(Channel& channel, Wire& wire)
    : channel_(channel),
      wire_(wire),
      events_(channel.subscribed()),
      since_(channel.info.events.size()),
      lent_(channel.info.commands.size()) {
  channel_.provider.takeJoining();
}

void ClientCarrier::give() {
  giveSubscription();
  giveCommands();
}

void ClientCarrier::giveSubscription() {
  const rt::ColumnSet columns = channel_.state->demand();
  const bool known = subscription_ != 0 && columns == columns_ && channel_.subscribed() == events_;
  if ((known && !channel_.provider.joining()) || !wire_.hasRoom(Message::Interest)) return;
  ++subscription_;
  const EventSet joining = channel_.provider.takeJoining();
  events_ = channel_.subscribed();  // read after takeJoining(), so it has all that join
  columns_ = columns;
  for (std::size_t i = 0; i < since_.size(); ++i) {
    if (joining >> i & 1) since_[i] = subscription_;
  }
  wire_.send(Interest{subscription_, events_, joining, columns_});
}

// Without room, commands stay with the client, where its credits bound them or newer ones replace
// them.
void ClientCarrier::giveCommands() {
  rt::Mailbox& commands = channel_.commands;
  if (!wire_.hasRoom(Message::Command) || !commands.pending()) return;
  commands.fixCut();
  giveSubscription();  // sent ahead of commands that were sent later
  while (wire_.hasRoom(Message::Command)) {
    const rt::CommandRecord* const record = commands.next();
    if (record == nullptr) return;
    if (begin(*record)) wire_.send(*record);
  }
}

/// Returns false if its client has cancelled it.
bool ClientCarrier::begin(const rt::CommandRecord& record) {
  const std::uint16_t number = record.command;
  if (record.call != 0 && !channel_.provider.claim(record.call)) {
    channel_.provider.replyError(record.call, Errc::Cancelled);
    arrival_ = true;
    rt::increment(channel_.commands.counters.cancelled);
    commandSent();
    giveBack(number, 1);
    ringClient();
    return false;
  }
  if (record.call != 0) placeOf(record.call) = {record.call, number};
  if (usesCredit(channel_.info.commands[number], record.call)) ++lent_[number];
  return true;
}

void ClientCarrier::refuse(const rt::CommandRecord& record, Errc error) {
  const std::uint16_t number = record.command;
  const bool usedCredit = usesCredit(channel_.info.commands[number], record.call);
  replyError(record.call, error);
  countRefused();
  commandSent();
  if (usedCredit) credits(number, 1);
  ringClient();
}

std::optional<std::uint16_t> ClientCarrier::commandOf(std::uint32_t call) const {
  const Call& place = calls_[call % calls_.size()];
  if (call == 0 || place.number != call) return std::nullopt;
  return place.command;
}

void ClientCarrier::reply(std::uint32_t call, Time stamp, Errc error,
                          std::span<const std::byte> result) {
  if (!commandOf(call)) return;
  if (error == Errc{}) {
    return reply(call, stamp, [&](std::byte* memory) {
      const BoundedLevels levels = channel_.info.commands[placeOf(call).command].resultLevels;
      if (!result.empty()) copyUsed(memory, result.data(), result.size(), levels);
      return Errc{};
    });
  }
  channel_.provider.replyError(call, error);
  placeOf(call).number = 0;
  arrival_ = true;
}

bool ClientCarrier::event(std::uint16_t event, std::uint32_t subscription, Time stamp,
                          const std::byte* payload) {
  if (subscription < since_[event]) return true;
  const EventInfo& info = channel_.info.events[event];
  if (!channel_.admits(info, payload)) return false;
  channel_.events.push(event, stamp, {payload, info.payloadSize});
  arrival_ = true;
  return true;
}

void ClientCarrier::row(Time stamp, rt::RowColumns columns,
                        std::span<const rt::StateTable::Value> values) {
  columns.keep(columns_);
  if (!columns.any()) return;
  if (values.empty()) {
    channel_.state->publish(stamp, columns);
  } else {
    channel_.state->publish(stamp, columns, values);
  }
  tellLane();
}

bool ClientCarrier::credits(std::uint16_t command, std::uint32_t count) {
  if (command >= lent_.size() || count > lent_[command]) return false;
  lent_[command] -= count;
  giveBack(command, count);
  tellLane();
  return true;
}

// Lowers the flag after it returns the credits: the client raises it before it looks for them
// again.
void ClientCarrier::giveBack(std::uint16_t command, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) channel_.commands.returnCredit(command);
  if (channel_.commands.roomAwaited().take(std::memory_order_acq_rel)) news_ = true;
}

void ClientCarrier::tally(const Tally& tally) {
  channel_.counts->told.store(tally);
  tellLane();
}

// A component looks by itself; a lane that leads from here to the client must be rung.
void ClientCarrier::tellLane() { news_ = news_ || channel_.provider.rowsAreWanted(); }

void ClientCarrier::ringClient() {
  if (news_) {
    channel_.ends.client->ring();
  } else if (arrival_) {
    channel_.ends.client->ring(rt::RungFor::Arrival);
  }
  arrival_ = news_ = false;
}

}  // namespace suture
