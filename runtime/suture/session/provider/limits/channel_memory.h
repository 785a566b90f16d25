#pragma once
// This bounds the memory that the connections of peers take in the provider's process.

#include <suture/component/channel/channel.h>
#include <suture/framing/peer_budget.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Belongs to the control thread. What a connection will need is held before it is built, and until
/// the last thread has dropped its channel. A task drops those that are over in its cycles, so one
/// that hangs or is stopped keeps them; those of a device are swept by the control thread.
class ChannelMemory {
 public:
  using Share = std::shared_ptr<framing::PeerBudget::Share>;

  explicit ChannelMemory(const framing::PeerBudget::Limits& limits)
      : budget_(std::make_shared<framing::PeerBudget>(limits)) {}

  /// Returns what counts for one connection of that peer; it holds nothing yet.
  Share share(const std::string& peer) const {
    return std::make_shared<framing::PeerBudget::Share>(budget_, peer);
  }
  /// Lets `share` hold so many bytes, and returns which limit that would break.
  std::optional<framing::PeerBudget::Beyond> hold(const Share& share, std::size_t bytes);
  /// Keeps `share` for as long as somebody has the channel that was built.
  void keep(const std::shared_ptr<Channel>& channel, Share share);

 private:
  struct Kept {
    std::weak_ptr<Channel> channel;
    Share share;
  };

  const std::shared_ptr<framing::PeerBudget> budget_;
  std::vector<Kept> kept_;
};

}  // namespace suture
