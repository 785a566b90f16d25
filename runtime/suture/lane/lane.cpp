#include <suture/lane/lane.h>

namespace suture {

Lane laneNamed(std::string_view name) {
  for (const Lane lane : {Lane::Shm, Lane::Frame, Lane::Rpc}) {
    if (lane.name == name) return lane;
  }
  return Lane::Auto;
}

}  // namespace suture
