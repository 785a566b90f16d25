#pragma once
// These are the two ends of a connection between two processes that share memory.

#include <suture/component/channel/channel.h>
#include <suture/lane/lane_kind.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace suture::shm {

/// Holds what a provider's process hands over, and its layout.
struct SharedParts {
  std::shared_ptr<MemoryBlock> channel;  ///< the queues; both write
  std::shared_ptr<MemoryBlock> state;    ///< the provider's table; only the provider writes
  std::shared_ptr<MemoryBlock> bell;     ///< wakes the provider's thread
  std::vector<std::uint32_t> columns;  ///< sizes: the contract's own first, a derived one's behind
  std::uint32_t rows = 0;
};

/// Holds a provider's end, before it is attached, and what the client needs for its own.
struct SharedOffer {
  std::shared_ptr<Channel> channel;
  SharedParts parts;
};

/// `client` is the memory of its doorbell. `watcher` is rung when the status changes. Throws
/// SetupError if there is no memory.
SharedOffer offerShared(const IncomingConnection& connection, std::shared_ptr<MemoryBlock> client,
                        std::shared_ptr<rt::Doorbell> watcher);

/// Return how many bytes the blocks of `parts` must have.
std::size_t channelBytes(const InterfaceInfo& contract);
std::size_t stateBytes(const SharedParts& parts);

/// Makes the client's end. Throws SetupError if `parts` are not what the contract needs.
std::shared_ptr<Channel> takeShared(OutgoingConnection connection, const SharedParts& parts);

}  // namespace suture::shm
