#include <suture/session/provider/shared/latest_connections.h>

namespace suture {

// A process that stood still may have lost its name to another meanwhile: it goes on with its
// session, asks last, and must not take the connection back from the one that has the name.
std::string LatestConnections::whySuperseded(const std::string& client, const std::string& name,
                                             const Latest& asked) const {
  const auto held = latest_.find(client);
  if (held == latest_.end()) return "";
  const Latest& latest = held->second;
  if (latest.bootId == asked.bootId && asked.epoch < latest.epoch) {
    return "connecting " + name +
           ": a later attempt of the same interface has come first. Nothing has to be done.";
  }
  if (latest.incarnation != asked.incarnation && asked.greeting < latest.greeting) {
    return "connecting " + name +
           ": another process of the same name came later and has this connection. End one of the "
           "two.";
  }
  return "";
}

void LatestConnections::end(const std::string& client) {
  if (const auto held = latest_.find(client); held != latest_.end()) held->second.end->end();
}

void LatestConnections::forget(const ProviderEnd& end) {
  std::erase_if(latest_, [&](const auto& one) { return one.second.end == &end; });
}

}  // namespace suture
