#pragma once
// These are the counts of one end of a channel. They live longer than the channel, as long as they
// are needed.

#include <suture/component/channel/counts/tally.h>
#include <suture/rt/queue/event_queue.h>
#include <suture/rt/queue/mailbox.h>

#include <cstdint>
#include <memory>

namespace suture {

/// Says which ends of a connection a process has.
enum class ConnectionEnd : std::uint8_t { Client, Provider, Both };

/// Any thread may read.
struct ChannelCounts {
  /// This end has counted own() itself, and the other has told it heard(). In foreign memory both
  /// processes see all counters, and each end counts only its own.
  Tally own(ConnectionEnd end) const;
  Tally heard(ConnectionEnd end) const;

  const std::shared_ptr<const rt::MailboxCounters> commands;
  const std::shared_ptr<const rt::EventCounters> events;
  const bool foreign;
  /// Client's end: the lane's thread writes here what the provider's end has told it.
  SharedTally told{};
  /// Client's end: the lane's thread writes here what it has decided itself, in the client's
  /// process, of commands that have left the mailbox.
  SharedTally decided{};
  /// Both ends in one process: count what ran in the thread that sent it. The first two are written
  /// by the client's thread.
  std::atomic<std::uint64_t> executedHere{0}, failedHere{0}, eventsHeardHere{0};
  /// Provider's end: counts commands that arrived but did not enter the mailbox. Written by the
  /// lane.
  std::atomic<std::uint64_t> turnedAway{0};
  /// Client's end: counts what the lane has lost although the connection stands. Written by the
  /// lane.
  std::atomic<std::uint64_t> lost{0};
};

}  // namespace suture
