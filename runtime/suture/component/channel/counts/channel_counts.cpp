#include <suture/component/channel/counts/channel_counts.h>
#include <suture/rt/counter.h>

namespace suture {
namespace {

/// Returns what the provider counts, because it takes the commands and emits the events.
Tally ofProvider(const rt::MailboxCounters& commands, const rt::EventCounters& events) {
  return {.executed = rt::count(commands.executed),
          .late = rt::count(commands.late),
          .refused = rt::count(commands.refused),
          .failed = rt::count(commands.failed),
          .replaced = rt::count(commands.overtaken),
          .superseded = rt::count(commands.superseded),
          .cancelled = rt::count(commands.cancelled),
          .eventsDropped = rt::count(events.dropped)};
}

}  // namespace

Tally ChannelCounts::own(ConnectionEnd end) const {
  Tally tally = decided.load();
  if (!foreign || end == ConnectionEnd::Provider) tally = tally + ofProvider(*commands, *events);
  if (!foreign || end == ConnectionEnd::Client) tally.replaced += rt::count(commands->replaced);
  tally.refused += rt::count(turnedAway);
  tally.executed += rt::count(executedHere);
  tally.failed += rt::count(failedHere);
  return tally;
}

Tally ChannelCounts::heard(ConnectionEnd end) const {
  const bool shared = foreign && end == ConnectionEnd::Client;
  return shared ? ofProvider(*commands, *events) : told.load();
}

}  // namespace suture
