#pragma once

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// After a longer pause of its task a scripted hand goes on from where it is. Otherwise it would
/// jump, because its path is a function of time.
inline constexpr suture::Duration kLongestPause = std::chrono::milliseconds(100);

}  // namespace robots
