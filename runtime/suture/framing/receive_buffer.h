#pragma once
// Bytes that have arrived and are not yet messages.

#include <kj/array.h>
#include <suture/framing/frame_header.h>

#include <cstddef>
#include <span>

#include <capnp/common.h>

namespace suture::rpc {

/// Holds what one receive brought, possibly several messages. A longer message arrives in memory of
/// its own, of which the kernel gives only what bytes have really arrived in (a header that
/// announces much costs nothing). Not thread-safe.
class ReceiveBuffer {
 public:
  explicit ReceiveBuffer(std::size_t bytes = 64u << 10);

  /// What has arrived.
  std::span<const std::byte> bytes() const;
  /// The message at the front has so many bytes (whole words), of which some are missing. Call it
  /// before space() as soon as that is known: the buffer itself has room for a header.
  void expect(std::size_t count);
  /// Returns where the next receive may write; never empty. Moves what is there if need be.
  std::span<std::byte> space();
  /// `count` bytes have been written at the start of space().
  void arrived(std::size_t count);
  /// Returns how much has arrived of a long message.
  std::size_t longBytes() const { return longEnd_; }
  /// It becomes as large when it is empty next.
  void setIdleSize(std::size_t bytes) { idleSize_ = bytes; }
  /// Takes the first `count` bytes (whole words) out, aligned: the memory of a long message, else a
  /// copy.
  kj::Array<capnp::word> take(std::size_t count);

 private:
  kj::Array<std::byte> storage_;
  std::size_t idleSize_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  kj::Array<capnp::word> long_;  // the message that is arriving, if it is a long one
  std::size_t longEnd_ = 0;
};

}  // namespace suture::rpc
