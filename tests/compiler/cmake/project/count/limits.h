#pragma once

namespace scratch {

// Of no target's HEADERS: reached through sample.h alone.
inline constexpr int kMost = 4;

}  // namespace scratch
