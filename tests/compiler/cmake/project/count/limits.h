#pragma once

namespace scratch {

// No target names this among its HEADERS: it is reached through sample.h alone.
inline constexpr int kMost = 4;

}  // namespace scratch
