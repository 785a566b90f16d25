#pragma once
// What a figure is worth depends on where it was measured.

#include <nlohmann/json.hpp>

namespace bench {

/// Processor, number of processors, kernel, load, compiler and build type.
nlohmann::json describeMachine();

}  // namespace bench
