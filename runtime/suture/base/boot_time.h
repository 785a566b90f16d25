#pragma once
// This is the clock that goes on while the machine is suspended.

#include <suture/base/time.h>

#include <chrono>

namespace suture {

/// Any thread; no allocation. Unlike the steady clock, this one goes on while the machine is
/// suspended. It bounds what must end after any pause of a process; stamps are of the steady clock.
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
