#pragma once
// This runs one loop, in one process or across two.

#include <cstdint>
#include <string>
#include <vector>

#include "bench/table2/setup.h"

namespace bench {

/// Is what came out of one loop, without the skipped samples.
struct LoopResult {
  std::vector<std::int64_t> elapsed;  ///< now - stamp where the stamp was made, ns
  std::vector<std::int64_t>
      client;  ///< SCS, event-driven: the whole loop as its client sees it, ns
  std::size_t failures = 0;
  std::string lane;
  std::uint64_t bytes = 0;  ///< that crossed the lane, both ways, at the client
};

/// Runs both tasks in this process. Throws SetupError.
LoopResult measureLocally(const LoopSetup& setup);

/// Runs the client here, the server in a process of its own, the global manager in this one. Throws
/// SetupError, also when the connection is not what it should be.
LoopResult measureAcross(const LoopSetup& setup, const Between& between);

}  // namespace bench
