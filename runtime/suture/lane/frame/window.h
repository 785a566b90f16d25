#pragma once
// This bounds how much one connection may have under way.

#include <suture/lane/frame/bytes/frame.h>

#include <cstdint>

namespace suture::frame {

/// At most kFrames are under way that the other end has not taken, so a peer that was stopped finds
/// no more than those when it goes on. It counts all frames except Acknowledge, modulo 2^32.
class Window {
 public:
  /// Equals one second at 1 kHz: a longer round trip would leave gaps between the frames.
  static constexpr std::uint32_t kFrames = 1024;
  /// Frames are acknowledged together when this many have been taken.
  static constexpr std::uint32_t kAcknowledged = 16;

  /// Returns true if one more frame may be sent.
  bool isOpen() const { return sent_ - acknowledged_ < kFrames; }
  /// Notes a frame that is sent, and says in it how many have been taken.
  void sends(Header& header) {
    header.acknowledged = told_ = taken_;
    if (header.kind != Kind::Acknowledge) ++sent_;
  }
  /// Notes a frame that has arrived. Returns false if the other end cannot have sent it: it says
  /// that more were taken than were sent, or fewer than before, or there is one too many.
  bool takes(const Header& header) {
    if (header.acknowledged - acknowledged_ > sent_ - acknowledged_) return false;
    acknowledged_ = header.acknowledged;
    if (header.kind == Kind::Acknowledge) return true;
    ++taken_;
    return taken_ - told_ <= kFrames;
  }
  bool owesAcknowledgement() const { return taken_ - told_ >= kAcknowledged; }

 private:
  std::uint32_t sent_ = 0, acknowledged_ = 0;  // ours, and how many of these the other end has
                                               // taken
  std::uint32_t taken_ = 0, told_ = 0;         // theirs, and how many of these are acknowledged
};

}  // namespace suture::frame
