#pragma once

#include <suture/annotate.h>

#include <cstdint>

namespace robots {

/// Holds what an absolute axis of an input device says at its two ends. `evtest` prints it.
struct SUTURE_TYPE() AxisRange {
  std::int32_t lowest = 0;
  std::int32_t highest = 0;
};

}  // namespace robots
