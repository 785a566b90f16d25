#include <suture/observe/merge.h>

#include <algorithm>

namespace suture {
namespace {

// Settles what the provider has counted since it last told its client.
void settleMore(ConnectionReport& whole, std::uint64_t commands) {
  for (std::uint64_t* const open : {&whole.underWay, &whole.unknown}) {
    const std::uint64_t settled = std::min(*open, commands);
    *open -= settled;
    commands -= settled;
  }
}

// The other end knows nothing of a process that was started anew since, so incarnations must match.
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
  const Tally& provided = provider;
  static_cast<Tally&>(whole) = client - client.heard + provided;
  whole.heard = {};
  settleMore(whole, (provided - client.heard).commands());
  whole.commandAge = provider.commandAge;
  if (whole.lastInvalid.empty()) whole.lastInvalid = provider.lastInvalid;
}

}  // namespace

std::vector<ConnectionReport> mergeConnections(const std::vector<Report>& reports) {
  std::vector<ConnectionReport> merged;
  std::vector<std::uint64_t> processes;  // those that the merged reports are of
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
