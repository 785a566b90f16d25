#pragma once
// This turns bytes as they arrive into whole, undamaged frames.

#include <suture/lane/frame/bytes/frame.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::frame {

/// One thread; no allocation after construction. It trusts nothing: it hands out a frame only if
/// its size, checksum, epoch, place in the order and kind are right, and after a wrong one it hands
/// out no more.
class FrameReader {
 public:
  explicit FrameReader(std::uint32_t epoch);

  /// Returns where the next bytes go; never empty. Invalidates what next() returned.
  std::span<std::byte> space();
  /// Call it when `count` bytes have been written at the start of space().
  void arrived(std::size_t count) { end_ += count; }

  /// Returns the next whole frame; nullptr: there is none yet, or a fault. It is valid until the
  /// next call.
  const Header* next();
  /// Returns the payload of the frame that next() returned, at a word; the caller may change it.
  std::span<std::byte> payload();
  Fault fault() const { return fault_; }

 private:
  const Header& header() const { return *reinterpret_cast<const Header*>(bytes() + begin_); }
  std::byte* bytes() { return reinterpret_cast<std::byte*>(storage_.data()); }
  const std::byte* bytes() const { return reinterpret_cast<const std::byte*>(storage_.data()); }
  Fault judge(const Header& header) const;
  const Header* broken(Fault fault);

  const std::uint32_t epoch_;
  std::vector<std::uint64_t> storage_;  // words, because frames lie at words
  std::size_t begin_ = 0, end_ = 0;     // bytes
  std::size_t taken_ = 0;               // bytes of the frame that next() returned
  std::uint32_t sequence_ = 0;
  Fault fault_ = Fault::None;
};

}  // namespace suture::frame
