#pragma once
// This says which faults the messages of a connection meet, for tests.

#include <suture/base/time.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace suture {

/// Counts how many messages each fault has hit. Any thread may read.
struct FaultCounts {
  std::atomic<std::uint64_t> lost{0}, burstLost{0}, duplicated{0}, reordered{0}, delayed{0},
      jittered{0}, stalls{0};

  std::uint64_t total() const {
    return lost + burstLost + duplicated + reordered + delayed + jittered + stalls;
  }
};

/// Says what happens to messages: commands, answers, events, rows of state. A chance is 0 to 1.
/// Each kind of message has its own sequence of faults, which only `seed` decides: the n-th command
/// of a connection meets the same ones in each run.
struct FaultPlan {
  std::uint64_t seed = 0;
  double loss = 0;           ///< chance to be lost
  double burst = 0;          ///< chance to be the first of `burstLength` that are lost
  unsigned burstLength = 8;  ///< messages
  double duplicate = 0;      ///< chance to arrive twice, the second time up to `holdBack` later
  double reorder = 0;        ///< chance to be held back for `holdBack`, so that others overtake
  Duration holdBack = std::chrono::milliseconds(5);
  double delay = 0;  ///< chance to take `delayLength` longer; what follows waits behind it
  Duration delayLength = std::chrono::milliseconds(20);
  /// The chance that a delayed message is delayed by as much once more, and so on: a stream repeats
  /// what was lost, and may lose the repetition too.
  double delayAgain = 0;
  Duration jitter{0};  ///< each takes up to this much longer, so that others may overtake
  /// Jitter keeps the order then: what follows a late message waits behind it, as on a stream.
  bool ordered = false;
  double stall = 0;  ///< chance that nothing arrives in this direction for `stallLength`
  Duration stallLength = std::chrono::milliseconds(100);
  /// Counts them; nullptr: nothing does. All connections of the plan share it.
  std::shared_ptr<FaultCounts> counts = nullptr;

  bool any() const {
    return loss > 0 || burst > 0 || duplicate > 0 || reorder > 0 || delay > 0 ||
           jitter > Duration{0} || stall > 0;
  }
};

}  // namespace suture
