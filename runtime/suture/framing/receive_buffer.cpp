#include <kj/debug.h>
#include <suture/framing/receive_buffer.h>

#include <cstring>

namespace suture::framing {

ReceiveBuffer::ReceiveBuffer(std::size_t bytes)
    : storage_(kj::heapArray<std::byte>(bytes)), idleSize_(bytes) {}

std::span<const std::byte> ReceiveBuffer::bytes() const {
  if (long_ != nullptr) return std::as_bytes(std::span(long_)).first(longEnd_);
  return std::span<const std::byte>(storage_).subspan(begin_, end_ - begin_);
}

void ReceiveBuffer::expect(std::size_t count) {
  if (long_ != nullptr || count <= storage_.size()) return;
  const auto begun = bytes();
  auto whole = kj::heapArray<capnp::word>(count / sizeof(capnp::word));
  std::memcpy(whole.begin(), begun.data(), begun.size());
  longEnd_ = begun.size();
  long_ = kj::mv(whole);
  begin_ = end_ = 0;
}

std::span<std::byte> ReceiveBuffer::space() {
  if (long_ != nullptr) return std::as_writable_bytes(std::span(long_)).subspan(longEnd_);
  if (begin_ == end_) {
    begin_ = end_ = 0;
    if (storage_.size() != idleSize_) storage_ = kj::heapArray<std::byte>(idleSize_);
  } else if (end_ > storage_.size() / 2 && begin_ > 0) {
    std::memmove(storage_.begin(), storage_.begin() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  KJ_ASSERT(end_ < storage_.size(), "what has arrived is longer than the buffer, and not expected");
  return std::span(storage_).subspan(end_);
}

void ReceiveBuffer::arrived(std::size_t count) { (long_ != nullptr ? longEnd_ : end_) += count; }

kj::Array<capnp::word> ReceiveBuffer::take(std::size_t count) {
  if (long_ != nullptr) {
    longEnd_ = 0;
    return kj::mv(long_);
  }
  auto words = kj::heapArray<capnp::word>(count / sizeof(capnp::word));
  std::memcpy(words.begin(), storage_.begin() + begin_, count);
  begin_ += count;
  return words;
}

}  // namespace suture::framing
