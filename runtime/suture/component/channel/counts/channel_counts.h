#pragma once
// The counts of one end of a channel. They live for as long as somebody asks for them, which is
// longer than the channel does.

#include <suture/component/channel/counts/tally.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>

#include <cstdint>
#include <memory>

namespace suture {

/// Which ends of a connection a process has.
enum class ConnectionEnd : std::uint8_t { Client, Provider, Both };

/// Any thread may read.
struct ChannelCounts {
  /// This end has counted own() itself, and the other has told it heard(). In foreign memory both
  /// processes see all counters, and each leaves the other's to it.
  Tally own(ConnectionEnd end) const;
  Tally heard(ConnectionEnd end) const;

  const std::shared_ptr<const rt::MailboxCounters> commands;
  const std::shared_ptr<const rt::EventCounters> events;
  const bool foreign;
  /// Client's end: the lane's thread writes what the provider's end has told it.
  SharedTally told{};
  /// Provider's end: how many have arrived that were not let into the mailbox. Written by the lane.
  std::atomic<std::uint64_t> turnedAway{0};
  /// Client's end: how many the lane has lost, though the connection stands. Written by the lane.
  std::atomic<std::uint64_t> lost{0};
};

}  // namespace suture
