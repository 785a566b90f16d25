#pragma once

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// After a longer pause of its task a scripted hand goes on from where it is: it would leap, for
/// its way is one of time.
inline constexpr suture::Duration kLongestPause = std::chrono::milliseconds(100);

}  // namespace robots
