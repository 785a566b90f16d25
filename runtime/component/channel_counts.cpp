#include <suture/component/channel_counts.h>

namespace suture {
namespace {

std::uint64_t count(const std::atomic<std::uint64_t>& counter) {
  return counter.load(std::memory_order_relaxed);
}

/// What the consumer of the commands and the producer of the events count.
Tally ofProvider(const rt::MailboxCounters& commands, const rt::EventCounters& events) {
  return {.executed = count(commands.executed),
          .late = count(commands.late),
          .refused = count(commands.refused),
          .failed = count(commands.failed),
          .superseded = count(commands.superseded),
          .cancelled = count(commands.cancelled),
          .eventsDropped = count(events.dropped)};
}

}  // namespace

Tally ChannelCounts::own(End end) const {
  Tally tally;
  if (!foreign || end == End::Provider) tally = ofProvider(*commands, *events);
  if (!foreign || end == End::Client) tally.replaced = count(commands->replaced);
  tally.refused += count(turnedAway);
  return tally;
}

Tally ChannelCounts::heard(End end) const {
  const bool shared = foreign && end == End::Client;
  return shared ? ofProvider(*commands, *events) : told.load();
}

}  // namespace suture
