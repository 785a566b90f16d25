#include <suture/lane/frame/connection.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {

Connection::Connection(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
                       std::uint32_t number)
    : channel_(std::move(channel)),
      payloads_(std::move(payloads)),
      number_(number),
      pieces_(payloads_->own(), payloads_->limit()) {}

bool Connection::over() const {
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  return broken() || status == ChannelStatus::Closed || status == ChannelStatus::Lost;
}

void Connection::breakOff(const std::string& why, const std::string& refusal) {
  if (over()) return;
  why_ = why;
  refusal_ = refusal;
  broken_.store(true, std::memory_order_release);
  channel_->ends.watcher->ring();
}

bool Connection::arrived(const Header& header, std::span<std::byte> payload) {
  rt::increment(channel_->bytesReceived, sizeof(header) + wordBytes(payload.size()));
  if (!window_.takes(header)) return false;
  if (header.kind == Kind::Acknowledge) return true;
  if (header.kind != Kind::Piece) {
    const bool right = pieces_.complete(header, payload, *surplus_) && take(header, payload);
    pieces_.taken(*surplus_);
    return right;
  }
  if (!pieces_.add(header, payload, *surplus_)) return false;
  takePart(static_cast<Kind>(header.number), pieces_.gathered());
  return true;
}

bool Connection::send() {
  if (!rest_.empty() && mayGoOn()) sendPiece();
  const bool more = give();
  if (!socket_->hasRoom()) return window_.isOpen() || window_.owesAcknowledgement();
  if (window_.owesAcknowledgement()) sendFrame({.kind = Kind::Acknowledge});
  return more || (!rest_.empty() && window_.isOpen());
}

void Connection::sendFrame(Header header, std::span<const std::byte> payload) {
  header.connection = number_;
  window_.sends(header);
  rt::increment(channel_->bytesSent, sizeof(header) + wordBytes(payload.size()));
  std::byte* const memory = socket_->begin(header, payload.size());
  if (!payload.empty()) std::memcpy(memory, payload.data(), payload.size());
  socket_->finish();
}

void Connection::sendValue(const Header& header, std::span<const std::byte> payload) {
  if (payload.size() > kMostPayload) {
    whole_ = header;
    wholeSize_ = static_cast<std::uint32_t>(payload.size());
    rest_ = payload;
    return sendPiece();
  }
  sendFrame(header, payload);
  letGo(header.kind);
}

void Connection::sendPiece() {
  const auto piece = rest_.first(std::min(rest_.size(), kMostPayload));
  rest_ = rest_.subspan(piece.size());
  if (!rest_.empty()) {
    return sendFrame({.kind = Kind::Piece,
                      .number = static_cast<std::uint16_t>(whole_.kind),
                      .call = wholeSize_},
                     piece);
  }
  sendFrame(whole_, piece);
  letGo(whole_.kind);
}

}  // namespace suture::frame
