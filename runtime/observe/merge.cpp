#include <suture/observe/merge.h>

#include <algorithm>

namespace suture {
namespace {

// The client end counts what was sent and how old its reads were; the provider end what was
// executed; a command can be dropped at either.
void complete(ConnectionReport& whole, const ConnectionReport& other) {
  const bool otherIsClient = other.end == ConnectionEnd::Client;
  const ConnectionReport client = otherIsClient ? other : whole;
  const ConnectionReport provider = otherIsClient ? whole : other;
  whole = client;
  whole.end = ConnectionEnd::Both;
  if (client.status == ChannelStatus::Connected) whole.status = provider.status;
  whole.executed = provider.executed;
  whole.late += provider.late;
  whole.superseded += provider.superseded;
  whole.replaced += provider.replaced;
  whole.full += provider.full;
  whole.tooLarge += provider.tooLarge;
  whole.invalid += provider.invalid;
  whole.failed += provider.failed;
  whole.refused += provider.refused;
  whole.eventsDropped += provider.eventsDropped;
  whole.commandAge = provider.commandAge;
}

}  // namespace

std::vector<ConnectionReport> mergeConnections(const std::vector<Report>& reports) {
  std::vector<ConnectionReport> merged;
  for (const Report& report : reports) {
    for (const ConnectionReport& one : report.connections) {
      const auto known =
          std::find_if(merged.begin(), merged.end(), [&](const ConnectionReport& whole) {
            return whole.name == one.name && whole.end != one.end &&
                   whole.end != ConnectionEnd::Both;
          });
      if (known == merged.end()) {
        merged.push_back(one);
      } else {
        complete(*known, one);
      }
    }
  }
  return merged;
}

}  // namespace suture
