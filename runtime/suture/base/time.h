#pragma once
// This is the one clock of a control system: monotonic, never stepped.

#include <atomic>
#include <chrono>
#include <cstdint>

namespace suture {

using Duration = std::chrono::nanoseconds;
using Clock = std::chrono::steady_clock;

/// A Time is a point on this process's steady clock. The default value means "unset": data stamped
/// with it are invalid, as in CRTK. A stamp that crosses a link is shifted to the reader's clock at
/// receipt.
using Time = std::chrono::time_point<Clock, Duration>;

class VirtualTime;

namespace detail {
extern std::atomic<VirtualTime*> virtualTime;
Time virtualNow(VirtualTime& time);
}  // namespace detail

/// Any thread. Returns the clock that steps this process's time, or null in production.
inline VirtualTime* virtualTime() { return detail::virtualTime.load(std::memory_order_relaxed); }

/// Any thread; never allocates. Returns the present time, or that of the clock which steps it.
inline Time now() {
  VirtualTime* const time = virtualTime();
  if (time != nullptr) [[unlikely]] {
    return detail::virtualNow(*time);
  }
  return Clock::now();
}

/// Any thread. Turn a time into the nanoseconds since the steady clock's epoch, and back.
inline std::int64_t toNanoseconds(Time time) { return time.time_since_epoch().count(); }
inline Time fromNanoseconds(std::int64_t count) { return Time{Duration{count}}; }

// These use raw counts so that includers need not compile chrono's operators.

/// Any thread. Returns when `duration` will be over; Time::max() if that is beyond what a Time can
/// hold, so that a wait of Duration::max() has no end.
inline Time fromNow(Duration duration) {
  const std::int64_t begin = toNanoseconds(now()), most = Time::max().time_since_epoch().count();
  return fromNanoseconds(duration.count() > most - begin ? most : begin + duration.count());
}
/// Any thread. Returns how long ago `then` was; negative if it is still to come.
inline Duration since(Time then) { return Duration{toNanoseconds(now()) - toNanoseconds(then)}; }
/// Any thread. Returns when it was `age` earlier than now.
inline Time ago(Duration age) { return fromNanoseconds(toNanoseconds(now()) - age.count()); }

}  // namespace suture
