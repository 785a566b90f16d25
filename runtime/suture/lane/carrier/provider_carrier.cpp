#include <suture/lane/carrier/provider_carrier.h>

#include <numeric>
#include <utility>

namespace suture {
namespace {

std::vector<std::uint16_t> sameNumbers(const InterfaceInfo& contract) {
  std::vector<std::uint16_t> numbers(contract.commands.size());
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  return numbers;
}

}  // namespace

ProviderCarrier::ProviderCarrier(Channel& channel, Wire& wire, std::vector<std::uint16_t> commands)
    : channel_(channel),
      wire_(wire),
      commands_(commands.empty() ? sameNumbers(channel.info) : std::move(commands)),
      waiting_(commands_.size()),
      since_(channel.info.events.size()) {
  // This also tells when commands have been taken, if a provider publishes no rows.
  channel_.client.askForRows();
}

// ---- from the client

Errc ProviderCarrier::whyNot(std::uint16_t command) const {
  const Errc error = errorOf(channel_.status.load(std::memory_order_acquire));
  if (error != Errc{}) return error;
  const bool withheld = readOnly_ && !channel_.info.commands[command].reads();
  return withheld ? Errc::NotPermitted : Errc{};
}

void ProviderCarrier::subscribe(const Interest& interest) {
  const EventSet joining = interest.joining & interest.events;
  subscription_ = interest.number;
  for (std::uint16_t i = 0; i < since_.size(); ++i) {
    if ((joining >> i & 1) == 0) continue;
    since_[i] = now();
    if (channel_.info.events[i].latched) channel_.events.beginAnew(i);
  }
  channel_.client.subscribe(interest.events, joining);
  columns_ = channel_.state->existing(interest.columns);
  lastRow_ = 0;
  channel_.state->askAll(columns_);
  work_ = true;
}

void ProviderCarrier::ringProvider() {
  if (std::exchange(work_, false)) channel_.ends.provider->ring();
}

// ---- to the client

bool ProviderCarrier::give() {
  giveReplies();
  giveCredits();
  giveTally();
  giveEvents();
  return giveRow();
}

void ProviderCarrier::giveReplies() {
  while (wire_.hasRoom(Message::Reply)) {
    const ReplyRecord* const reply = channel_.client.nextReply();
    if (reply == nullptr) return;
    wire_.send(*reply);
  }
}

void ProviderCarrier::giveCredits() {
  for (std::uint16_t theirs = 0; theirs < waiting_.size(); ++theirs) {
    if (waiting_[theirs] == 0) continue;
    const std::uint16_t command = commands_[theirs];
    const std::uint32_t there = command == kUnknown ? 0 : channel_.commands.waiting(command);
    if (there >= waiting_[theirs]) continue;
    if (!wire_.hasRoom(Message::Credits)) return;
    const std::uint32_t taken = waiting_[theirs] - there;
    waiting_[theirs] = there;
    wire_.sendCredits(theirs, taken);
  }
}

void ProviderCarrier::giveTally() {
  const Tally tally = channel_.counts->own(ConnectionEnd::Provider);
  if (tally == tally_ || !wire_.hasRoom(Message::Tally)) return;
  tally_ = tally;
  wire_.send(tally_);
}

void ProviderCarrier::giveEvents() {
  while (wire_.hasRoom(Message::Event)) {
    const rt::EventRecord* const record = channel_.events.next();
    if (record == nullptr) return;
    if (wanted(*record)) {
      wire_.send(*record, subscription_);
    } else {
      eventSent();
    }
  }
}

// The last value of a latched event is older than its subscription, but has been put in since then.
bool ProviderCarrier::wanted(const rt::EventRecord& record) const {
  if ((channel_.subscribed() >> record.event & 1) == 0) return false;
  if (channel_.info.events[record.event].latched) return !channel_.events.fromBefore();
  return record.stamp >= since_[record.event];
}

bool ProviderCarrier::giveRow() {
  if (columns_ == 0 || !wire_.hasRoom(Message::Row)) return false;
  return wire_.sendRow(columns_, lastRow_);
}

}  // namespace suture
