#include <suture/loop/failure.h>
#include <suture/session/provider/lane_servers.h>

namespace suture {

kj::Promise<LaneServer*> LaneServers::named(const std::string& name) {
  if (LaneServer* const lane = find(name)) return lane;
  return shared_.published.reached().then([this, name]() -> kj::Promise<LaneServer*> {
    if (LaneServer* const lane = find(name)) return lane;
    return loop::failure(kj::Exception::Type::FAILED,
                         "the provider's process has no lane '" + name + "'");
  });
}

LaneServer* LaneServers::find(const std::string& name) {
  if (const auto found = lanes_.find(name); found != lanes_.end()) return found->second.get();
  const auto kind = findLane(shared_.lanes, name);
  if (kind == shared_.lanes.end()) return nullptr;
  return lanes_.emplace(name, (*kind)->makeServer(session_)).first->second.get();
}

}  // namespace suture
