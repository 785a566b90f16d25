#pragma once
// Payloads that are larger than a frame's, as their pieces arrive.

#include <suture/lane/frame/bytes/frame.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::frame {

/// Joins the pieces of one connection. One thread. Room is made as they come, and kept: only a
/// value that is larger than all before it allocates.
class Pieces {
 public:
  /// `limit`: no payload is larger.
  explicit Pieces(std::size_t limit) : limit_(limit) {}

  /// A Piece has arrived; false if there can be no such.
  bool add(const Header& header, std::span<const std::byte> piece);
  /// All that has come of the payload; valid until the next call, at a word.
  std::span<std::byte> gathered() { return {bytes(), gathered_}; }
  /// Turns the payload of a frame of another kind into all of it, if pieces came before it: valid
  /// until the next call, at a word. False if it is not the end of them.
  bool complete(const Header& header, std::span<std::byte>& payload);

 private:
  std::byte* bytes() { return reinterpret_cast<std::byte*>(storage_.data()); }
  void append(std::span<const std::byte> more);

  const std::size_t limit_;
  std::vector<std::uint64_t> storage_;
  std::size_t gathered_ = 0, whole_ = 0;  // bytes
  std::uint16_t kind_ = 0;                // of the frame that brings the end
};

}  // namespace suture::frame
