#pragma once
// This is the floor of the shm lane: two rings and two futexes in memory that two processes share.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Returns the round trips of a PoseSample between two processes on processor `cpu`, ns; the first
/// `skip` are left out. No other thread of this process may run. Throws SetupError.
std::vector<std::int64_t> bareMemoryRounds(int cpu, std::size_t skip, std::size_t samples);

}  // namespace bench
