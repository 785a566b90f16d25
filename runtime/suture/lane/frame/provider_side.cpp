#include <suture/base/slots/used_parts.h>
#include <suture/component/channel/credit.h>
#include <suture/lane/carrier/arrival_stamp.h>
#include <suture/lane/frame/provider_side.h>

#include <cstring>
#include <utility>

namespace suture::frame {

ProviderSide::ProviderSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                           std::uint32_t number, ClientCommands commands)
    : Connection(std::move(channel), std::move(payloads), number),
      latest_(std::move(commands.latest)),
      row_(*channel_->state),
      carrier_(*channel_, *this, std::move(commands.numbers)) {}

// ---- from the client

bool ProviderSide::take(const Header& header, std::span<std::byte> payload) {
  heard_ = true;
  switch (header.kind) {
    case Kind::Command: return takeCommand(header, payload);
    case Kind::Subscribe: return takeSubscription(header, payload);
    default: return false;
  }
}

// A command that is refused, because it is unknown here or the queue here is shorter than the
// client's, uses its credit until the client is told.
bool ProviderSide::takeCommand(const Header& header, std::span<std::byte> payload) {
  if (header.number >= carrier_.commands()) return false;
  if (hasUsedCredit(header)) carrier_.lend(header.number);
  const std::uint16_t number = carrier_.commandAt(header.number);
  if (number == kUnknown) return tellRefused(header, Errc::NotImplemented);
  const CommandInfo& command = channel_->info.commands[number];
  const ArrivedValue value =
      payloads_->open({Kind::Command, number}, payload, channel_->clockShift());
  if (value.slot == nullptr) return false;
  const auto copy = [&](std::byte* arguments) {
    if (value.error != Errc{}) return value.error;
    copyUsed(arguments, value.slot, command.argumentsSize, command.argumentsLevels);
    return Errc{};
  };
  const Time sent = arrivalStamp(*channel_, header.stamp);
  return tellRefused(header, carrier_.post(number, sent, header.call, copy).error);
}

// The client counts its credits by its own contract.
bool ProviderSide::hasUsedCredit(const Header& header) const {
  const std::uint16_t theirs = header.number;
  if (theirs < latest_.size()) return usesCredit(latest_[theirs], header.call);
  const std::uint16_t number = carrier_.commandAt(theirs);
  return number == kUnknown || usesCredit(channel_->info.commands[number], header.call);
}

bool ProviderSide::tellRefused(const Header& header, Errc error) {
  if (error == Errc{}) return true;
  carrier_.countRefused();
  if (header.call == 0) return true;
  if (refusedCallCount_ == refusedCalls_.size()) return false;
  refusedCalls_[refusedCallCount_++] = {header.call, error};
  return true;
}

bool ProviderSide::takeSubscription(const Header& header, std::span<const std::byte> payload) {
  Subscription wanted;
  if (payload.size() != sizeof(wanted)) return false;
  std::memcpy(&wanted, payload.data(), sizeof(wanted));
  const InterfaceInfo& contract = channel_->info;
  row_.giveUp();
  carrier_.subscribe({.number = header.call,
                      .events = fromWireNumbers(contract.wireEvents, wanted.events),
                      .joining = fromWireNumbers(contract.wireEvents, wanted.joining),
                      .columns = fromWireNumbers(contract.wireColumns, wanted.columns)});
  return true;
}

// ---- to the client

bool ProviderSide::give() {
  if (!heard_) return false;
  sendRefusals();
  return carrier_.give();
}

void ProviderSide::sendRefusals() {
  while (refusedCallCount_ > 0 && Connection::hasRoom()) {
    const RefusedCall& one = refusedCalls_[--refusedCallCount_];
    sendFrame(
        {.kind = Kind::Reply, .error = static_cast<std::uint8_t>(one.error), .call = one.call});
  }
}

void ProviderSide::send(const ReplyRecord& reply) {
  std::span<const std::byte> result;
  Errc error = reply.error;
  if (error == Errc{}) result = payloads_->pack({Kind::Reply, reply.command}, reply.result());
  if (!fits(result)) {
    error = Errc::TooLarge;
    result = {};
  }
  sendValue({.kind = Kind::Reply,
             .error = static_cast<std::uint8_t>(error),
             .call = reply.call,
             .stamp = toNanoseconds(reply.stamp)},
            result);
}

void ProviderSide::sendCredits(std::uint16_t command, std::uint32_t count) {
  sendFrame({.kind = Kind::Taken, .number = command, .call = count});
}

void ProviderSide::send(const Tally& tally) {
  sendFrame({.kind = Kind::Tally}, std::as_bytes(std::span(&tally, 1)));
}

void ProviderSide::send(const rt::EventRecord& event, std::uint32_t subscription) {
  const auto payload = payloads_->pack({Kind::Event, event.event}, event.payload());
  if (!fits(payload)) {
    channel_->events.countDropped();
    return carrier_.eventSent();
  }
  sendValue({.kind = Kind::Event,
             .number = numberAt(channel_->info.wireEvents, event.event),
             .call = subscription,
             .stamp = toNanoseconds(event.stamp)},
            payload);
}

bool ProviderSide::sendRow(rt::ColumnSet columns, std::uint64_t& last) {
  if (!row_.underWay()) {
    if (channel_->state->rows() == last) return false;
    row_.begin(payloads_->slotsOf(columns), columns);
  }
  if (!row_.go()) return true;
  rt::StateTable::Row row = row_.row();
  last = row.sequence;
  if (!row.any()) return false;
  auto values = payloads_->packRow(row);
  if (!fits(values)) {
    row.tooLarge |= std::exchange(row.valid, 0);
    values = payloads_->packRow(row);
  }
  sendValue({.kind = Kind::Row, .stamp = toNanoseconds(row.stamp)}, values);
  return false;
}

void ProviderSide::letGo(Kind kind) {
  if (kind == Kind::Reply) carrier_.replySent();
  if (kind == Kind::Event) carrier_.eventSent();
}

}  // namespace suture::frame
