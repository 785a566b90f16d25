#pragma once
// From bytes as they arrive to whole, undamaged frames.

#include <suture/lane/frame/codec/frame.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture::frame {

/// One thread. Believes nothing: a frame is handed out only if its size, checksum, epoch, place in
/// the order and kind are right, and after a wrong one there are no more. No allocation after
/// construction, but for what allow() says.
class FrameReader {
 public:
  /// `mostPayload`: no frame has more.
  FrameReader(std::uint32_t epoch, std::size_t mostPayload);

  /// From now on there may be larger ones. Ends what next() returned.
  void makeRoom(std::size_t mostPayload);
  /// From now on there may be even larger ones, for which room is made as they come.
  void allow(std::size_t limit) { limit_ = std::max(limit_, limit); }

  /// Where the next bytes go; never empty. Ends what next() returned.
  std::span<std::byte> space();
  /// `count` bytes have been written at the start of space().
  void arrived(std::size_t count) { end_ += count; }

  /// The next whole frame; nullptr: there is none yet, or a fault. Valid until the next call.
  const Header* next();
  /// The payload of the frame that next() returned, at a word; whoever takes it may change it.
  std::span<std::byte> payload();
  Fault fault() const { return fault_; }

 private:
  const Header& header() const { return *reinterpret_cast<const Header*>(bytes() + begin_); }
  std::byte* bytes() { return reinterpret_cast<std::byte*>(storage_.data()); }
  const std::byte* bytes() const { return reinterpret_cast<const std::byte*>(storage_.data()); }
  Fault judge(const Header& header) const;
  const Header* broken(Fault fault);

  const std::uint32_t epoch_;
  std::size_t mostPayload_;
  std::size_t limit_ = 0;
  std::vector<std::uint64_t> storage_;  // words: frames lie at words
  std::size_t begin_ = 0, end_ = 0;     // bytes
  std::size_t taken_ = 0;               // of the frame that next() returned
  std::uint32_t sequence_ = 0;
  Fault fault_ = Fault::None;
};

}  // namespace suture::frame
