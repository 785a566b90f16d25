#include <suture/lane/frame/connection.h>
#include <suture/rt/counter.h>
#include <suture/wire/stamps.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {
namespace {

std::size_t rowBytes(const InterfaceInfo& contract) {
  std::size_t size = sizeof(rt::RowColumns);
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) size += wordBytes(one.resultSize);
  }
  return size;
}

}  // namespace

std::size_t mostPayload(const InterfaceInfo& contract) {
  std::size_t most = std::max({sizeof(Subscription), sizeof(Tally), rowBytes(contract)});
  for (const CommandInfo& one : contract.commands) {
    most = std::max<std::size_t>({most, one.argumentsSize, one.resultSize});
  }
  for (const EventInfo& one : contract.events) most = std::max<std::size_t>(most, one.payloadSize);
  return most;
}

Connection::Connection(std::shared_ptr<Channel> channel, std::uint32_t number)
    : channel_(std::move(channel)), number_(number) {}

bool Connection::over() const {
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  return broken() || status == ChannelStatus::Closed || status == ChannelStatus::Lost;
}

void Connection::breakOff(const std::string& why) {
  if (over()) return;
  why_ = why;
  broken_.store(true, std::memory_order_release);
  channel_->ends.watcher->ring();
}

bool Connection::arrived(const Header& header, std::span<std::byte> payload) {
  rt::increment(channel_->bytesReceived, sizeof(header) + wordBytes(payload.size()));
  if (!window_.takes(header)) return false;
  return header.kind == Kind::Acknowledge || take(header, payload);
}

bool Connection::send() {
  give();
  if (!socket_->hasRoom()) return window_.isOpen() || window_.owesAcknowledgement();
  if (window_.owesAcknowledgement()) {
    begin({.kind = Kind::Acknowledge}, 0);
    finish();
  }
  return false;
}

std::byte* Connection::begin(Header header, std::size_t size) {
  header.connection = number_;
  window_.sends(header);
  rt::increment(channel_->bytesSent, sizeof(header) + wordBytes(size));
  return socket_->begin(header, size);
}

void Connection::send(const Header& header, std::span<const std::byte> payload) {
  std::byte* const memory = begin(header, payload.size());
  if (!payload.empty()) std::memcpy(memory, payload.data(), payload.size());
  finish();
}

Time Connection::here(std::int64_t stamp) const {
  return std::clamp(fromNanoseconds(rpc::shifted(stamp, channel_->clockShift())), Time{}, now());
}

void Connection::bringHere(StampShift shift, std::byte* slot) const {
  if (shift == nullptr) return;
  const Duration ahead = channel_->clockShift();
  if (ahead != Duration{0}) shift(slot, ahead);
}

}  // namespace suture::frame
