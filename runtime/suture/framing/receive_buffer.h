#pragma once
// Bytes that have arrived and are not yet messages.

#include <kj/array.h>
#include <suture/framing/frame_header.h>

#include <cstddef>
#include <span>

#include <capnp/common.h>

namespace suture::rpc {

/// Holds what one receive brought, possibly several messages, and grows only as bytes really arrive
/// (a header that announces much costs nothing). Not thread-safe.
class ReceiveBuffer {
 public:
  explicit ReceiveBuffer(std::size_t bytes = 64u << 10);

  /// What has arrived.
  std::span<const std::byte> bytes() const { return {storage_.begin() + begin_, end_ - begin_}; }
  /// Where the next receive may write; never empty. Moves or grows what is there if need be.
  std::span<std::byte> space();
  /// `count` bytes have been written at the start of space().
  void arrived(std::size_t count) { end_ += count; }
  /// Returns how much it holds beyond its idle size.
  std::size_t grown() const {
    return storage_.size() > idleSize_ ? storage_.size() - idleSize_ : 0;
  }
  /// It becomes as large when it is empty next.
  void setIdleSize(std::size_t bytes) { idleSize_ = bytes; }
  /// Takes the first `count` bytes (whole words) out, as an aligned copy.
  kj::Array<capnp::word> take(std::size_t count);

 private:
  kj::Array<std::byte> storage_;
  std::size_t idleSize_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace suture::rpc
