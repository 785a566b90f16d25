#pragma once
// This bounds the memory that a link's connections take beyond their contracts.

#include <cstddef>

namespace suture::frame {

/// One thread. A newer peer's values may be larger than a contract says here, but not without end:
/// all connections of a link together may take this much for that.
class Surplus {
 public:
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  /// Returns false if less is left.
  bool take(std::size_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  void giveBack(std::size_t bytes) { left_ += bytes; }

 private:
  std::size_t left_ = kMost;
};

}  // namespace suture::frame
