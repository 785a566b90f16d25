#pragma once
// What one end of a channel counts, for as long as anybody asks: longer than the channel lives.

#include <suture/component/tally.h>
#include <suture/rt/event_queue.h>
#include <suture/rt/mailbox.h>

#include <cstdint>
#include <memory>

namespace suture {

/// Any thread may read.
struct ChannelCounts {
  /// Which end of the channel this process has.
  enum class End : std::uint8_t { Client, Provider, Both };

  /// What this end has counted itself, and what the other has told it. In foreign memory both
  /// processes see all counters, and each leaves the other's to it.
  Tally own(End end) const;
  Tally heard(End end) const;

  const std::shared_ptr<const rt::MailboxCounters> commands;
  const std::shared_ptr<const rt::EventCounters> events;
  const bool foreign;
  /// Of the commands that have left this end: the lane's thread writes what the provider's end has
  /// counted.
  SharedTally told{};
  /// Provider's end: how many have arrived that were not let into the mailbox. Written by the lane.
  std::atomic<std::uint64_t> turnedAway{0};
  /// Client's end: how many the lane has lost, though the connection stands. Written by the lane.
  std::atomic<std::uint64_t> lost{0};
};

}  // namespace suture
