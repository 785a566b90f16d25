#pragma once

#include <suture/annotate.h>

#include <cstdint>

namespace robots {

/// Says which of two it is, as the surgeon at the console sees them.
enum class SUTURE_TYPE() Side : std::uint8_t { Left, Right };

}  // namespace robots
