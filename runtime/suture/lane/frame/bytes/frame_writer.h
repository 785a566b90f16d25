#pragma once
// This holds frames on their way to the socket.

#include <suture/lane/frame/bytes/frame.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace suture::frame {

/// One thread. Collects frames until they are sent, so that many leave in one send. No allocation
/// after construction if hasRoom() is asked before begin().
class FrameWriter {
 public:
  explicit FrameWriter(std::uint32_t epoch);

  /// Returns true if the largest frame, and an Acknowledge behind it, have room.
  bool hasRoom() const;
  /// Returns memory for the payload of a new frame with `size` bytes of it, which the caller fills;
  /// finish() ends the frame.
  std::byte* begin(Header header, std::size_t size);
  void finish();

  /// Returns what has been finished and not yet been sent.
  std::span<const std::byte> unsent() const { return {bytes_.get() + sent_, end_ - sent_}; }
  void sent(std::size_t count);

 private:
  const std::uint32_t epoch_;
  const std::unique_ptr<std::byte[]> bytes_;  // uninitialised, because only what is in a frame is
                                              // sent
  std::size_t sent_ = 0, open_ = 0, end_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace suture::frame
