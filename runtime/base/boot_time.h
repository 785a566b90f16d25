#pragma once
// The clock that goes on while the machine is suspended.

#include <suture/base/time.h>

#include <chrono>

namespace suture {

/// Counts what the steady clock leaves out: the time for which the machine was suspended. For
/// what must be over after any pause of a process; stamps are of the steady clock. Any thread; no
/// allocation.
struct BootClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<BootClock, duration>;
  static constexpr bool is_steady = true;

  static time_point now();
};

using BootTime = BootClock::time_point;

}  // namespace suture
