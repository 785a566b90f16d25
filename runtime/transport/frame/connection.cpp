#include <suture/transport/frame/connection.h>
#include <suture/transport/rpc/stamps.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {
namespace {

std::size_t rowBytes(const InterfaceInfo& contract) {
  std::size_t size = sizeof(Columns);
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) size += wordBytes(one.resultSize);
  }
  return size;
}

}  // namespace

std::size_t mostPayload(const InterfaceInfo& contract) {
  std::size_t most = std::max(sizeof(Subscription), rowBytes(contract));
  for (const CommandInfo& one : contract.commands) {
    most = std::max<std::size_t>({most, one.argumentsSize, one.resultSize});
  }
  for (const EventInfo& one : contract.events) most = std::max<std::size_t>(most, one.payloadSize);
  return most;
}

Connection::Connection(std::shared_ptr<Channel> channel, rpc::ByteStream bytes, const Terms& terms)
    : channel_(std::move(channel)),
      socket_(std::move(bytes), terms.epoch, mostPayload(channel_->info)),
      shift_(terms.shift) {}

bool Connection::over() const {
  const ChannelStatus status = channel_->status.load(std::memory_order_acquire);
  return broken() || status == ChannelStatus::Closed || status == ChannelStatus::Lost;
}

void Connection::turn() {
  if (over()) return;
  receive();
  give();
  socket_.flush();
  channel_->bytesSent.store(socket_.sentBytes(), std::memory_order_relaxed);
  channel_->bytesReceived.store(socket_.receivedBytes(), std::memory_order_relaxed);
  if (!socket_.broken()) return;
  broken_.store(true, std::memory_order_release);
  channel_->ends.watcher->ring();
}

void Connection::receive() {
  bool any = false;
  while (const Header* const header = socket_.next()) {
    if (!take(*header, socket_.payload())) return socket_.breakOff("a frame makes no sense");
    any = true;
  }
  if (any) taken();
}

Time Connection::here(std::int64_t stamp) const {
  return std::clamp(fromNanoseconds(rpc::shifted(stamp, shift_)), Time{}, now());
}

void Connection::bringHere(StampShift shift, std::byte* slot) const {
  if (shift != nullptr && shift_ != Duration{0}) shift(slot, shift_);
}

void Connection::send(const Header& header, std::span<const std::byte> payload) {
  std::byte* const memory = socket_.begin(header, payload.size());
  if (!payload.empty()) std::memcpy(memory, payload.data(), payload.size());
  socket_.finish();
}

}  // namespace suture::frame
