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

/// One thread. Joins the pieces of one connection. Memory grows as they come. What the contract
/// here may need is kept, so only a value that is larger than all before it, or than those of the
/// contract, allocates.
class Pieces {
 public:
  /// `own` is the size of the largest payload that this process's contract has; `limit` bounds all
  /// payloads.
  Pieces(std::size_t own, std::size_t limit) : own_(wordBytes(own)), limit_(limit) {}

  /// Takes a Piece. Returns false if it cannot be right, or `surplus` has nothing left for it.
  bool add(const Header& header, std::span<const std::byte> piece, Surplus& surplus);
  /// Returns what has come of the payload; it is valid until the next call, and lies at a word.
  std::span<std::byte> gathered() { return {bytes(), gathered_}; }
  /// Replaces the payload of a frame of another kind by the whole payload, if pieces came before
  /// it; it is valid until the next call, at a word. Returns false if the frame is not the end of
  /// them.
  bool complete(const Header& header, std::span<std::byte>& payload, Surplus& surplus);
  /// Call it when a payload that complete() returned is no longer used: gives back to `surplus`
  /// what the contract here does not need.
  void taken(Surplus& surplus);
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
  std::uint16_t kind_ = 0;                // the kind of the frame that brings the end
};

}  // namespace suture::frame
