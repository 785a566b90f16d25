#include <suture/session/provider/limits/channel_memory.h>

#include <utility>

namespace suture {

std::optional<framing::PeerBudget::Beyond> ChannelMemory::hold(const Share& share,
                                                               std::size_t bytes) {
  std::erase_if(kept_, [](const Kept& one) { return one.channel.expired(); });
  return share->hold(bytes);
}

void ChannelMemory::keep(const std::shared_ptr<Channel>& channel, Share share) {
  kept_.push_back({channel, std::move(share)});
}

}  // namespace suture
