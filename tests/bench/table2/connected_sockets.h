#pragma once
// These are two ends of a bare socket, for what is measured without Suture.

#include <array>

#include "bench/table2/setup.h"

namespace bench {

/// A SocketPair holds the descriptors of two connected, blocking stream sockets.
using SocketPair = std::array<int, 2>;

/// Connects them, over the loopback if it is TCP, with each send leaving at once. Throws
/// SetupError.
SocketPair connectedSockets(Transport transport);

}  // namespace bench
