#pragma once
// This joins the pieces in which payloads arrive that are larger than a frame's.

#include <suture/lane/frame/bytes/frame.h>
#include <suture/lane/frame/bytes/surplus.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::frame {

/// Joins the pieces of one connection. One thread. Room is made as they come, and kept: only a
/// value that is larger than all before it allocates.
class Pieces {
 public:
  /// `own`: bytes of the largest payload that this process's contract has; `limit`: no payload is
  /// larger.
  Pieces(std::size_t own, std::size_t limit) : own_(own), limit_(limit) {}

  /// A Piece has arrived; false if there can be no such, or `surplus` has nothing left for it.
  bool add(const Header& header, std::span<const std::byte> piece, Surplus& surplus);
  /// Returns all that has come of the payload; it is valid until the next call, and lies at a word.
  std::span<std::byte> gathered() { return {bytes(), gathered_}; }
  /// Turns the payload of a frame of another kind into all of it, if pieces came before it: valid
  /// until the next call, at a word. False if it is not the end of them.
  bool complete(const Header& header, std::span<std::byte>& payload, Surplus& surplus);
  /// Returns how much of the link's surplus this has taken.
  std::size_t surplus() const { return surplusOf(storage_.size()); }

 private:
  std::byte* bytes() { return reinterpret_cast<std::byte*>(storage_.data()); }
  bool append(std::span<const std::byte> more, Surplus& surplus);
  std::size_t surplusOf(std::size_t words) const {
    return std::max(words * sizeof(std::uint64_t), own_) - own_;
  }

  const std::size_t own_, limit_;
  std::vector<std::uint64_t> storage_;
  std::size_t gathered_ = 0, whole_ = 0;  // bytes
  std::uint16_t kind_ = 0;                // of the frame that brings the end
};

}  // namespace suture::frame
