#pragma once
// Execution is what is left of a command when nothing has to be carried.

#include <cstddef>

#include "bench/figures/statistics.h"

namespace bench {

/// ns a command on a device of the same process, which the client's thread calls directly: the
/// checks, casts, dereferences and the virtual call. Each sample is the mean of one loop of 10,000.
Statistics measureExecution(std::size_t loops);

}  // namespace bench
