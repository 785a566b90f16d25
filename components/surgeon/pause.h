#pragma once

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// After a longer pause of its task a scripted hand goes on from where it is, because its path is
/// one of time, and it would jump otherwise.
inline constexpr suture::Duration kLongestPause = std::chrono::milliseconds(100);

}  // namespace robots
