#pragma once
// This runs one loop, in one process or across two.

#include <cstdint>
#include <string>
#include <vector>

#include "bench/table2/setup.h"

namespace bench {

/// Holds what one loop measured, without the skipped samples.
struct LoopResult {
  std::vector<std::int64_t> elapsed;  ///< now - stamp where the stamp was made, ns
  /// Holds the whole loop as its client sees it, ns; only for Loop::Scs with Pace::EventDriven.
  std::vector<std::int64_t> client;
  std::size_t failures = 0;
  std::string lane;
  std::uint64_t bytes = 0;  ///< that crossed the lane, both ways, as the client counts them
};

/// Runs both tasks in this process. Throws SetupError.
LoopResult measureLocally(const LoopSetup& setup);

/// Runs the client and the global manager in this process, and the server in a process of its own.
/// Throws SetupError, also when the connection is not what it should be.
LoopResult measureAcross(const LoopSetup& setup, const Between& between);

}  // namespace bench
