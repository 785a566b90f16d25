#pragma once
// The one clock of a control system: monotonic, never stepped.

#include <chrono>
#include <cstdint>

namespace suture {

using Duration = std::chrono::nanoseconds;
using Clock = std::chrono::steady_clock;

/// A point on this process's steady clock. The default value means "unset": data stamped with it
/// are invalid, as in CRTK. A stamp that crosses a link is shifted to the reader's clock at
/// receipt.
using Time = std::chrono::time_point<Clock, Duration>;

/// Any thread; no allocation.
inline Time now() { return Clock::now(); }

inline std::int64_t toNanoseconds(Time time) { return time.time_since_epoch().count(); }
inline Time fromNanoseconds(std::int64_t count) { return Time{Duration{count}}; }

}  // namespace suture
