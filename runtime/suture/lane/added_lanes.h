#pragma once
// This is how a program names the lanes that it brings.

#include <functional>
#include <memory>
#include <vector>

namespace suture {

class LaneKind;

/// Makes the lanes of a program beside the runtime's own; empty: it has none.
using AddedLanes = std::function<std::vector<std::unique_ptr<LaneKind>>()>;

}  // namespace suture
