#include <suture/observe/merge.h>

#include <algorithm>

namespace suture {
namespace {

Tally tallyOf(const ConnectionReport& one) {
  return {.executed = one.executed,
          .late = one.late,
          .refused = one.refused,
          .failed = one.failed,
          .replaced = one.replaced,
          .superseded = one.superseded,
          .cancelled = one.cancelled,
          .eventsDropped = one.eventsDropped};
}

// What the provider has counted since it last told its client.
void settleMore(ConnectionReport& whole, std::uint64_t commands) {
  for (std::uint64_t* const open : {&whole.underWay, &whole.unknown}) {
    const std::uint64_t settled = std::min(*open, commands);
    *open -= settled;
    commands -= settled;
  }
}

// Counts of a process that has been started anew since are not those that the other end knows of.
bool areOfOneConnection(const ConnectionReport& one, std::uint64_t processOfOne,
                        const ConnectionReport& other, std::uint64_t processOfOther) {
  return one.name == other.name && one.end != other.end && one.end != ConnectionEnd::Both &&
         other.end != ConnectionEnd::Both && one.otherIncarnation == processOfOther &&
         other.otherIncarnation == processOfOne;
}

// The client end counts what was sent and how old its reads were; the provider end what was
// executed; a command can be dropped at either.
void complete(ConnectionReport& whole, const ConnectionReport& other) {
  const bool otherIsClient = other.end == ConnectionEnd::Client;
  const ConnectionReport client = otherIsClient ? other : whole;
  const ConnectionReport provider = otherIsClient ? whole : other;
  whole = client;
  whole.end = ConnectionEnd::Both;
  if (client.status == ChannelStatus::Connected) whole.status = provider.status;
  const Tally& heard = client.heard;
  const auto exact = [](std::uint64_t clients, std::uint64_t told, std::uint64_t providers) {
    return clients - std::min(clients, told) + providers;
  };
  whole.executed = exact(client.executed, heard.executed, provider.executed);
  whole.late = exact(client.late, heard.late, provider.late);
  whole.superseded = exact(client.superseded, heard.superseded, provider.superseded);
  whole.replaced = exact(client.replaced, heard.replaced, provider.replaced);
  whole.failed = exact(client.failed, heard.failed, provider.failed);
  whole.refused = exact(client.refused, heard.refused, provider.refused);
  whole.cancelled = exact(client.cancelled, heard.cancelled, provider.cancelled);
  whole.eventsDropped = exact(client.eventsDropped, heard.eventsDropped, provider.eventsDropped);
  whole.heard = {};
  settleMore(whole, (tallyOf(provider) - heard).commands());
  whole.commandAge = provider.commandAge;
}

}  // namespace

std::vector<ConnectionReport> mergeConnections(const std::vector<Report>& reports) {
  std::vector<ConnectionReport> merged;
  std::vector<std::uint64_t> processes;  // that the merged ones are of
  for (const Report& report : reports) {
    for (const ConnectionReport& one : report.connections) {
      std::size_t i = 0;
      while (i < merged.size() &&
             !areOfOneConnection(merged[i], processes[i], one, report.incarnation)) {
        ++i;
      }
      if (i < merged.size()) {
        complete(merged[i], one);
      } else {
        merged.push_back(one);
        processes.push_back(report.incarnation);
      }
    }
  }
  return merged;
}

}  // namespace suture
