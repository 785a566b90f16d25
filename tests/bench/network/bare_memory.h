#pragma once
// This is the floor of the shm lane: two rings and two futexes in memory that two processes share.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Returns the round trips of `bytes` bytes between two processes on processor `cpu`, ns; the first
/// `skip` are left out. Each end copies them in once and out once. No other thread of this process
/// may run. Throws SetupError.
std::vector<std::int64_t> bareMemoryRounds(std::size_t bytes, int cpu, std::size_t skip,
                                           std::size_t samples);

}  // namespace bench
