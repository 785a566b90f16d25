#pragma once
// A session keeps here, for all of its channels, what it knows of the process at its other end.

#include <suture/base/boot_time.h>
#include <suture/base/time.h>

#include <atomic>

namespace suture {

/// The control thread writes it, and any thread may read it.
struct PeerState {
  /// The first is added to the peer's stamps to have them on this process's clock. The second is
  /// how wrong that was, either way, when the clocks were compared last. Both are zero if the
  /// processes share a clock.
  std::atomic<Duration> clockShift{Duration{0}}, clockError{Duration{0}};
  /// Says when the last message was sent that the peer has answered since.
  std::atomic<BootTime> heard{BootTime{}};
};

/// Returns how far two quartz clocks may drift apart in that time, each off by up to 50 us in a
/// second.
constexpr Duration clockDrift(Duration elapsed) {
  constexpr int kMicroseconds = 100;
  return elapsed * kMicroseconds / 1'000'000;
}

}  // namespace suture
