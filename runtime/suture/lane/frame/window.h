#pragma once
// How much one connection may have under way.

#include <suture/lane/frame/bytes/frame.h>

#include <cstdint>

namespace suture::frame {

/// At most kFrames that the other end has not taken: a peer that is stopped finds no more than
/// those when it goes on. Counts frames but for Acknowledge, beyond 2^32 from zero again.
class Window {
 public:
  /// What comes at 1 kHz in a second: a longer round trip would leave gaps between the frames.
  static constexpr std::uint32_t kFrames = 1024;
  /// So many that have been taken are acknowledged together.
  static constexpr std::uint32_t kAcknowledged = 16;

  /// True if one more frame may be sent.
  bool isOpen() const { return sent_ - acknowledged_ < kFrames; }
  /// A frame is sent, which tells what has been taken.
  void sends(Header& header) {
    header.acknowledged = told_ = taken_;
    if (header.kind != Kind::Acknowledge) ++sent_;
  }
  /// A frame has arrived; false if the other end cannot have sent it: it says that more were taken
  /// than were sent, or fewer than before, or there is one too many.
  bool takes(const Header& header) {
    if (header.acknowledged - acknowledged_ > sent_ - acknowledged_) return false;
    acknowledged_ = header.acknowledged;
    if (header.kind == Kind::Acknowledge) return true;
    ++taken_;
    return taken_ - told_ <= kFrames;
  }
  bool owesAcknowledgement() const { return taken_ - told_ >= kAcknowledged; }

 private:
  std::uint32_t sent_ = 0, acknowledged_ = 0;  // ours, and of these taken by the other end
  std::uint32_t taken_ = 0, told_ = 0;         // theirs, and of these acknowledged
};

}  // namespace suture::frame
