#pragma once
// A session chooses from these lanes.

#include <suture/lane/lane_kind.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// The fastest stands first: each connection travels by the first that it can have.
using Lanes = std::vector<std::unique_ptr<LaneKind>>;

/// Returns all lanes. Throws SetupError if the kernel refuses what one needs.
Lanes makeLanes();

/// Returns their names, in that order.
std::vector<std::string> laneNames(const Lanes& lanes);

/// Returns the one of that name; end() if there is none.
Lanes::const_iterator findLane(const Lanes& lanes, std::string_view name);

}  // namespace suture
