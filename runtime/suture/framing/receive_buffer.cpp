#include <suture/framing/receive_buffer.h>

#include <cstring>

namespace suture::rpc {

ReceiveBuffer::ReceiveBuffer(std::size_t bytes)
    : storage_(kj::heapArray<std::byte>(bytes)), idleSize_(bytes) {}

std::span<std::byte> ReceiveBuffer::space() {
  if (begin_ == end_) {
    begin_ = end_ = 0;
    if (storage_.size() != idleSize_) storage_ = kj::heapArray<std::byte>(idleSize_);
  } else if (end_ > storage_.size() / 2 && begin_ > 0) {
    std::memmove(storage_.begin(), storage_.begin() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == storage_.size()) {
    auto larger = kj::heapArray<std::byte>(storage_.size() * 2);
    std::memcpy(larger.begin(), storage_.begin(), end_);
    storage_ = kj::mv(larger);
  }
  return {storage_.begin() + end_, storage_.size() - end_};
}

kj::Array<capnp::word> ReceiveBuffer::take(std::size_t count) {
  auto words = kj::heapArray<capnp::word>(count / sizeof(capnp::word));
  std::memcpy(words.begin(), storage_.begin() + begin_, count);
  begin_ += count;
  return words;
}

}  // namespace suture::rpc
