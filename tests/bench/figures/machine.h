#pragma once
// This says where a figure was measured, since its worth depends on that.

#include <nlohmann/json.hpp>

namespace bench {

/// Processor, number of processors, kernel, load, compiler and build type.
nlohmann::json describeMachine();

}  // namespace bench
