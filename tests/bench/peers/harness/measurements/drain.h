#pragma once

#include <cstdint>

#include "harness/control_block.h"

namespace peers {

/// Waits until `wanted` have come, and returns true; false if none has come for so long that the
/// others are lost.
bool drain(const Received& received, std::uint64_t wanted);

}  // namespace peers
