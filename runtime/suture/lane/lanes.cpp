#include <suture/lane/frame/frame_lane.h>
#include <suture/lane/lanes.h>
#include <suture/lane/rpc/calls_lane.h>
#include <suture/lane/shm/shared_lane.h>

#include <algorithm>

namespace suture {

Lanes makeLanes() {
  Lanes lanes;
  lanes.push_back(std::make_unique<shm::SharedLane>());
  lanes.push_back(std::make_unique<frame::FrameLane>());
  lanes.push_back(std::make_unique<rpc::CallsLane>());
  return lanes;
}

std::vector<std::string> laneNames(const Lanes& lanes) {
  std::vector<std::string> names;
  for (const auto& kind : lanes) names.emplace_back(kind->name());
  return names;
}

Lanes::const_iterator findLane(const Lanes& lanes, std::string_view name) {
  return std::find_if(lanes.begin(), lanes.end(),
                      [name](const auto& kind) { return kind->name() == name; });
}

}  // namespace suture
