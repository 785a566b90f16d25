#pragma once
// This bounds the memory that a link's connections take beyond their contracts.

#include <suture/framing/peer_budget.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace suture::frame {

/// One thread. A newer peer's values may be larger than contracts say here. This bounds what they
/// take beyond that: all connections of a link together may take kMost bytes, and if the peer has
/// called this process, no more than the peer's budget has left.
class Surplus {
 public:
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  /// `share` counts it; null: the peer was called, so that only kMost bounds it.
  explicit Surplus(std::unique_ptr<framing::PeerBudget::Share> share = nullptr)
      : share_(std::move(share)) {}

  /// Returns false if less is left; whyNot() says of what.
  bool take(std::size_t bytes) {
    if (bytes > kMost - taken_) {
      whyNot_ = "the values of its connections would need more than " + std::to_string(kMost) +
                " bytes beyond their contracts. Send smaller ones";
    } else if (const auto beyond = hold(taken_ + bytes)) {
      whyNot_ = framing::unfinishedBeyond(*beyond);
    } else {
      taken_ += bytes;
      return true;
    }
    return false;
  }
  void giveBack(std::size_t bytes) {
    taken_ -= bytes;
    hold(taken_);
  }
  /// Returns in words why the last take() failed; "" if none has.
  const std::string& whyNot() const { return whyNot_; }

 private:
  std::optional<framing::PeerBudget::Beyond> hold(std::size_t bytes) {
    return share_ == nullptr ? std::nullopt : share_->hold(bytes);
  }

  const std::unique_ptr<framing::PeerBudget::Share> share_;
  std::size_t taken_ = 0;
  std::string whyNot_;
};

}  // namespace suture::frame
