#pragma once
// This is the floor of a fan-out: the same bytes, written to as many sockets.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

struct FanOut {
  std::vector<std::int64_t> ages;  ///< ns: how old each value is when its receiver has it
  double load = 0;                 ///< %: how much of one processor both sides take together
};

/// Writes once a millisecond `bytes` bytes to each of `receivers` Unix sockets, which another
/// process reads by one epoll; `rounds` times. No other thread of this process may run. Throws
/// SetupError.
FanOut bareFanOut(std::size_t bytes, std::size_t receivers, std::size_t rounds);

}  // namespace bench
