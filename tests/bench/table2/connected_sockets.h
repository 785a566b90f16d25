#pragma once
// These are two ends of a bare socket, for what is measured without Suture.

#include <array>

#include "bench/table2/setup.h"

namespace bench {

/// A SocketPair holds the descriptors of two connected, blocking stream sockets.
using SocketPair = std::array<int, 2>;

/// Connects a pair, TCP over the loopback and with TCP_NODELAY. Takes Tls for Unix, because a bare
/// socket has none. Throws SetupError. The caller closes both.
SocketPair connectedSockets(Transport transport);

}  // namespace bench
