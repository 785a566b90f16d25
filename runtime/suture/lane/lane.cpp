#include <suture/lane/lane.h>

namespace suture {

const char* toString(Lane lane) {
  switch (lane) {
    case Lane::Auto: return "auto";
    case Lane::Shm: return "shm";
    case Lane::Frame: return "frame";
    case Lane::Rpc: return "rpc";
  }
  return "";
}

Lane laneNamed(std::string_view name) {
  for (const Lane lane : {Lane::Shm, Lane::Frame, Lane::Rpc}) {
    if (name == toString(lane)) return lane;
  }
  return Lane::Auto;
}

}  // namespace suture
