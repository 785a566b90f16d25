#include <suture/base/nearest.h>
#include <suture/lane/lane_refusals.h>

namespace suture {

SetupError laneUnknown(const std::string& connection, const Lane& lane,
                       const std::vector<std::string>& known) {
  return SetupError("connecting " + connection,
                    "this process has no lane '" + lane.name + "'; it has " + listNames(known),
                    "Ask for one of these, or add it with addLane() first");
}

SetupError laneRefused(const std::string& connection, const Lane& lane, const std::string& why) {
  return SetupError("connecting " + connection,
                    "lane '" + lane.name + "' is required and cannot carry it: " + why,
                    "Remove the reason, or let it have any lane");
}

}  // namespace suture
