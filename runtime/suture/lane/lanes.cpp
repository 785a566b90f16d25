#include <suture/lane/frame/frame_lane.h>
#include <suture/lane/lanes.h>
#include <suture/lane/rpc/calls_lane.h>
#include <suture/lane/shm/shared_lane.h>

namespace suture {

Lanes makeLanes() {
  Lanes lanes;
  lanes.push_back(std::make_unique<shm::SharedLane>());
  lanes.push_back(std::make_unique<frame::FrameLane>());
  lanes.push_back(std::make_unique<rpc::CallsLane>());
  return lanes;
}

}  // namespace suture
