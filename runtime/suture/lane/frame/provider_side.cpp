#include <suture/lane/frame/provider_side.h>
#include <suture/rt/counter.h>

#include <cstring>
#include <numeric>
#include <utility>

namespace suture::frame {
namespace {

std::vector<std::uint16_t> sameNumbers(const InterfaceInfo& contract) {
  std::vector<std::uint16_t> numbers(contract.commands.size());
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  return numbers;
}

}  // namespace

ProviderSide::ProviderSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                           std::uint32_t number, std::vector<std::uint16_t> commands)
    : Connection(std::move(channel), std::move(payloads), number),
      commands_(commands.empty() ? sameNumbers(channel_->info) : std::move(commands)),
      waiting_(commands_.size()),
      since_(channel_->info.events.size(), now()),
      row_(*channel_->state) {
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

// A command that is not known here uses its credit until the client is told so.
bool ProviderSide::takeCommand(const Header& header, std::span<std::byte> payload) {
  if (header.number >= commands_.size()) return false;
  const std::uint16_t number = commands_[header.number];
  const bool known = number != kUnknown;
  const CommandInfo* const command = known ? &channel_->info.commands[number] : nullptr;
  if (!known || !command->latest || header.call != 0) {
    if (known && waiting_[header.number] == command->depth) return false;
    ++waiting_[header.number];
  }
  if (!known) return refuse(header, Errc::NotImplemented);
  const ArrivedValue value =
      payloads_->open({Kind::Command, number}, payload, channel_->clockShift());
  if (value.slot == nullptr) return false;
  Errc error = whyNot(number);
  if (error == Errc{}) error = value.error;
  if (error == Errc{}) error = post(header, number, value.slot);
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

Errc ProviderSide::whyNot(std::uint16_t command) const {
  const Errc error = errorOf(channel_->status.load(std::memory_order_acquire));
  if (error != Errc{}) return error;
  const bool withheld = readOnly_ && !channel_->info.commands[command].reads();
  return withheld ? Errc::NotPermitted : Errc{};
}

Errc ProviderSide::post(const Header& header, std::uint16_t number, const std::byte* arguments) {
  const CommandInfo& command = channel_->info.commands[number];
  const auto slot = channel_->commands.claim(number, here(header.stamp), header.call);
  if (!slot) return slot.error();
  std::memcpy(*slot, arguments, command.argumentsSize);
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
  const InterfaceInfo& contract = channel_->info;
  const EventSet events = fromWireNumbers(contract.wireEvents, wanted.events);
  const EventSet joining = fromWireNumbers(contract.wireEvents, wanted.joining) & events;
  const rt::ColumnSet columns = fromWireNumbers(contract.wireColumns, wanted.columns);
  subscription_ = header.call;
  for (std::size_t i = 0; i < since_.size(); ++i) {
    if (joining >> i & 1) since_[i] = now();
  }
  channel_->subscribe(events, joining);
  columns_ = channel_->state->existing(columns);
  lastRow_ = 0;
  row_.giveUp();
  channel_->state->askAll(columns_);
  work_ = true;
  return true;
}

// ---- to the client

bool ProviderSide::give() {
  if (!heard_) return false;
  giveReplies();
  giveRefusals();
  giveCredits();
  giveTally();
  giveEvents();
  return giveRow();
}

void ProviderSide::giveReplies() {
  while (hasRoom()) {
    const ReplyRecord* const reply = channel_->nextReply();
    if (reply == nullptr) return;
    std::span<const std::byte> result;
    if (reply->error == Errc{}) {
      result = payloads_->pack({Kind::Reply, reply->command}, reply->result());
    }
    sendValue({.kind = Kind::Reply,
               .error = static_cast<std::uint8_t>(reply->error),
               .call = reply->call,
               .stamp = toNanoseconds(reply->stamp)},
              result);
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
  for (std::uint16_t theirs = 0; theirs < waiting_.size(); ++theirs) {
    if (waiting_[theirs] == 0) continue;
    const std::uint16_t command = commands_[theirs];
    const std::uint32_t there = command == kUnknown ? 0 : channel_->commands.waiting(command);
    if (there >= waiting_[theirs]) continue;
    if (!hasRoom()) return;
    send({.kind = Kind::Taken, .number = theirs, .call = waiting_[theirs] - there});
    waiting_[theirs] = there;
  }
}

void ProviderSide::giveEvents() {
  while (hasRoom()) {
    const rt::EventRecord* const record = channel_->events.next();
    if (record == nullptr) return;
    if (!wanted(*record)) {
      channel_->events.pop();
      continue;
    }
    sendValue({.kind = Kind::Event,
               .number = numberAt(channel_->info.wireEvents, record->event),
               .call = subscription_,
               .stamp = toNanoseconds(record->stamp)},
              payloads_->pack({Kind::Event, record->event}, record->payload()));
  }
}

// The value of a latched event may be older than its subscription, for it is a replay.
bool ProviderSide::wanted(const rt::EventRecord& record) const {
  if ((channel_->subscribed() >> record.event & 1) == 0) return false;
  return record.stamp >= since_[record.event] || channel_->info.events[record.event].latched;
}

// True: there is more of the row to copy.
bool ProviderSide::giveRow() {
  const rt::StateTable& state = *channel_->state;
  if (columns_ == 0 || !hasRoom()) return false;
  if (!row_.underWay()) {
    if (state.rows() == lastRow_) return false;
    row_.begin(payloads_->slotsOf(columns_), columns_);
  }
  if (!row_.go()) return true;
  const rt::StateTable::Row& row = row_.row();
  lastRow_ = row.sequence;
  if (!row.any()) return false;
  sendValue({.kind = Kind::Row, .stamp = toNanoseconds(row.stamp)}, payloads_->packRow(row));
  return false;
}

void ProviderSide::letGo(Kind kind) {
  if (kind == Kind::Reply) channel_->popReply();
  if (kind == Kind::Event) channel_->events.pop();
}

}  // namespace suture::frame
