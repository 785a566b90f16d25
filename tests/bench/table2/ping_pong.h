#pragma once
// This is the floor: the same bytes over a bare socket.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/table2/setup.h"

namespace bench {

/// Returns how long each round trip of `bytes` bytes takes between two processes on processor `cpu`
/// that block on the socket, in ns; the first `skip` are left out. No other thread of this process
/// may run. Throws SetupError.
std::vector<std::int64_t> pingPong(Transport transport, std::size_t bytes, std::optional<int> cpu,
                                   std::size_t skip, std::size_t samples);

}  // namespace bench
