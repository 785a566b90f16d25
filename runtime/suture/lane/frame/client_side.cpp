#include <suture/lane/carrier/arrival_stamp.h>
#include <suture/lane/frame/client_side.h>

#include <cstring>

namespace suture::frame {

ClientSide::ClientSide(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                       std::uint32_t number)
    : Connection(std::move(channel), std::move(payloads), number), carrier_(*channel_, *this) {}

// ---- from the provider

bool ClientSide::take(const Header& header, std::span<std::byte> payload) {
  switch (header.kind) {
    case Kind::Reply: return takeReply(header, payload);
    case Kind::Event: return takeEvent(header, payload);
    case Kind::Row: return takeRow(header, payload);
    case Kind::Taken: return carrier_.credits(header.number, header.call);
    case Kind::Tally: return takeTally(payload);
    default: return false;
  }
}

void ClientSide::takePart(Kind kind, std::span<std::byte> payload) {
  if (kind == Kind::Row) payloads_->openRowPart(payload, channel_->clockShift(), *channel_->state);
}

// An answer to a call that is no longer known comes too late, so it is dropped.
bool ClientSide::takeReply(const Header& header, std::span<std::byte> payload) {
  const auto command = carrier_.commandOf(header.call);
  if (!command) return true;
  ArrivedValue result{nullptr, static_cast<Errc>(header.error)};
  if (result.error == Errc{}) {
    result = payloads_->open({Kind::Reply, *command}, payload, channel_->clockShift());
    if (result.slot == nullptr) return false;
  } else if (!payload.empty()) {
    return false;
  }
  const std::uint32_t size = channel_->info.commands[*command].resultSize;
  carrier_.reply(header.call, arrivalStamp(*channel_, header.stamp), result.error,
                 {result.slot, result.error == Errc{} ? size : 0});
  return true;
}

// The loss of one event must not end a connection.
bool ClientSide::takeEvent(const Header& header, std::span<std::byte> payload) {
  const std::size_t number = placeOf(channel_->info.wireEvents, header.number);
  if (number >= channel_->info.events.size()) return false;
  const auto event = static_cast<std::uint16_t>(number);
  const ArrivedValue value = payloads_->open({Kind::Event, event}, payload, channel_->clockShift());
  if (value.slot == nullptr) return false;
  const Time stamp = arrivalStamp(*channel_, header.stamp);
  if (value.error != Errc{} || !carrier_.event(event, header.call, stamp, value.slot)) {
    channel_->events.countDropped();
  }
  return true;
}

bool ClientSide::takeRow(const Header& header, std::span<std::byte> payload) {
  const auto row = payloads_->openRow(payload, channel_->clockShift(), *channel_->state);
  if (!row) return false;
  carrier_.row(arrivalStamp(*channel_, header.stamp), row->columns, row->values);
  return true;
}

bool ClientSide::takeTally(std::span<const std::byte> payload) {
  Tally tally;
  if (payload.size() != sizeof(tally)) return false;
  std::memcpy(&tally, payload.data(), sizeof(tally));
  carrier_.tally(tally);
  return true;
}

// ---- to the provider

bool ClientSide::give() {
  carrier_.give();
  return false;
}

void ClientSide::send(const Interest& interest) {
  const InterfaceInfo& contract = channel_->info;
  const Subscription content{.events = toWireNumbers(contract.wireEvents, interest.events),
                             .joining = toWireNumbers(contract.wireEvents, interest.joining),
                             .columns = toWireNumbers(contract.wireColumns, interest.columns)};
  sendFrame({.kind = Kind::Subscribe, .call = interest.number},
            std::as_bytes(std::span(&content, 1)));
}

void ClientSide::send(const rt::CommandRecord& command) {
  const auto arguments = payloads_->pack({Kind::Command, command.command}, command.arguments());
  if (!fits(arguments)) return carrier_.refuse(command, Errc::TooLarge);
  sendValue({.kind = Kind::Command,
             .number = command.command,
             .call = command.call,
             .stamp = toNanoseconds(command.stamp)},
            arguments);
}

}  // namespace suture::frame
