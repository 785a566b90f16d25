#include <suture/lane/lane_limits.h>
#include <suture/lane/shm/shared_lane.h>

namespace suture {

// The other lanes carry every contract between any two processes.
std::string whyNever(Lane lane, const InterfaceInfo& contract, bool byUnixSocket) {
  return lane == Lane::Shm ? shm::whyNever(contract, byUnixSocket) : "";
}

SetupError laneRefused(const std::string& connection, Lane lane, const std::string& why) {
  return SetupError("connecting " + connection,
                    "lane '" + toString(lane) + "' is required and cannot carry it: " + why,
                    "Remove the reason, or let it have any lane");
}

}  // namespace suture
