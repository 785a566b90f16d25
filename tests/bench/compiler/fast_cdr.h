#pragma once
// This measures the serializer of Fast DDS with the same record, to compare ours with it.

#include <cstddef>
#include <optional>

#include "bench/figures/statistics.h"
#include "robot_types/pose.h"

namespace bench {

/// Returns the ns to serialize `value` and to deserialize it into a second object, both in memory
/// that is used again; nothing where this program was built without Fast CDR.
std::optional<Statistics> fastCdrBothWays(const robots::PosePrm& value, std::size_t loops,
                                          std::size_t length);

}  // namespace bench
