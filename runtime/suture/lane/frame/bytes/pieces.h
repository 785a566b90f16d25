#pragma once
// Payloads that are larger than a frame's, as their pieces arrive.

#include <suture/lane/frame/bytes/frame.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::frame {

/// What values in pieces of all connections of a link may take beyond what their contracts say
/// here: those of a newer peer may be larger, but not without end. One thread.
class Surplus {
 public:
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  /// False if there is not so much left.
  bool take(std::size_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  void giveBack(std::size_t bytes) { left_ += bytes; }

 private:
  std::size_t left_ = kMost;
};

/// Joins the pieces of one connection. One thread. Room is made as they come, and kept: only a
/// value that is larger than all before it allocates.
class Pieces {
 public:
  /// `own`: bytes of the largest payload that this process's contract has; `limit`: no payload is
  /// larger.
  Pieces(std::size_t own, std::size_t limit) : own_(own), limit_(limit) {}

  /// A Piece has arrived; false if there can be no such, or `surplus` has nothing left for it.
  bool add(const Header& header, std::span<const std::byte> piece, Surplus& surplus);
  /// All that has come of the payload; valid until the next call, at a word.
  std::span<std::byte> gathered() { return {bytes(), gathered_}; }
  /// Turns the payload of a frame of another kind into all of it, if pieces came before it: valid
  /// until the next call, at a word. False if it is not the end of them.
  bool complete(const Header& header, std::span<std::byte>& payload, Surplus& surplus);
  /// What it has taken from the link's.
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
