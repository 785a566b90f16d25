#pragma once
// The lanes from which a session chooses.

#include <suture/lane/lane_kind.h>

#include <memory>
#include <string_view>
#include <vector>

namespace suture {

/// The fastest first: each connection travels by the first that it can have.
using Lanes = std::vector<std::unique_ptr<LaneKind>>;

/// Throws SetupError if the kernel refuses what one needs.
Lanes makeLanes();

/// The one of that name; end() if there is none.
Lanes::const_iterator findLane(const Lanes& lanes, std::string_view name);

}  // namespace suture
