#include <suture/lane/frame/connection.h>
#include <suture/rt/counter.h>
#include <suture/wire/stamps.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {

Connection::Connection(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                       std::uint32_t number)
    : channel_(std::move(channel)), payloads_(std::move(payloads)), number_(number) {}

std::size_t Connection::mostPayload() const {
  return std::max({sizeof(Subscription), sizeof(Tally), payloads_->most()});
}

std::size_t Connection::payloadLimit() const { return std::max(mostPayload(), payloads_->limit()); }

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

}  // namespace suture::frame
