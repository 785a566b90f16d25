#pragma once
// This bounds what a link's connections take beyond their contracts.

#include <cstddef>

namespace suture::frame {

/// A newer peer's values may be larger than a contract says here, but not without end: this is what
/// all connections of a link may take for that. One thread.
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

}  // namespace suture::frame
