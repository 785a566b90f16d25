#pragma once
// This holds bytes that have arrived and are not yet messages.

#include <kj/array.h>
#include <suture/framing/message_header.h>

#include <cstddef>
#include <span>

#include <capnp/common.h>

namespace suture::framing {

/// One thread. Holds what one receive brought, possibly several messages. A longer message arrives
/// in memory of its own, of which the kernel provides only what bytes have really arrived in, so a
/// header that announces much costs nothing.
class ReceiveBuffer {
 public:
  explicit ReceiveBuffer(std::size_t bytes = 64u << 10);

  /// Returns what has arrived.
  std::span<const std::byte> bytes() const;
  /// Says that the message at the front has `count` bytes (whole words), of which some are missing.
  /// Call it before space() as soon as that is known: the buffer itself has only room for a header.
  void expect(std::size_t count);
  /// Returns where the next receive may write; it is never empty. Moves the bytes that are there if
  /// necessary.
  std::span<std::byte> space();
  /// Says that `count` bytes have been written at the start of space().
  void arrived(std::size_t count);
  /// Returns how much has arrived of a long message.
  std::size_t longBytes() const { return longEnd_; }
  /// Sets the size that the buffer gets when it is empty the next time.
  void setIdleSize(std::size_t bytes) { idleSize_ = bytes; }
  /// Takes the first `count` bytes (whole words) out and returns them aligned: the memory of a long
  /// message itself, else a copy.
  kj::Array<capnp::word> take(std::size_t count);

 private:
  kj::Array<std::byte> storage_;
  std::size_t idleSize_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  kj::Array<capnp::word> long_;  // the message that is arriving, if it is a long one
  std::size_t longEnd_ = 0;
};

}  // namespace suture::framing
