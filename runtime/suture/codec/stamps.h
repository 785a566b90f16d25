#pragma once
// These read points in time that a peer names. Any thread.

#include <suture/base/time.h>

#include <algorithm>
#include <limits>

namespace suture::codec {

/// Returns nanoseconds as a peer says them, at most 146 years from zero, so that sums and
/// differences of two fit.
inline std::int64_t bounded(std::int64_t nanoseconds) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
  return std::clamp(nanoseconds, -kMost, kMost);
}

/// Returns a steady stamp of the peer on this process's clock, bounded so that its age can be
/// computed. Unset stays unset.
inline std::int64_t shifted(std::int64_t stamp, Duration shift) {
  return stamp == 0 ? 0 : bounded(bounded(stamp) + bounded(shift.count()));
}

}  // namespace suture::codec
