#pragma once
// This is the floor of streams: the same messages over a bare socket.

#include <cstddef>

#include "bench/table2/setup.h"

namespace bench {

/// Returns how many millions of messages of `bytes` bytes a second go from a process on `cpu` to
/// one on `otherCpu`: each is one send, and a receipt takes what there is. No other thread of this
/// process may run. Throws SetupError.
double bareStream(Transport transport, std::size_t bytes, int cpu, int otherCpu,
                  std::size_t messages);

}  // namespace bench
