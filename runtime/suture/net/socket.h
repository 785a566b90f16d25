#pragma once
// Sockets as the links want them.

#include <kj/io.h>
#include <suture/base/time.h>
#include <suture/net/address.h>

namespace suture::rpc {

/// An unconnected stream socket of the address's family: non-blocking, closed on exec. Throws
/// SetupError.
kj::AutoCloseFd openSocket(const Address& address);

/// TCP only: every send leaves at once.
void sendWithoutDelay(int socket);

/// TCP only: the kernel takes no more while about so many bytes wait there to be sent for the first
/// time. What is sent later waits behind them, so they are few; its buffer has megabytes.
inline constexpr int kMostUnsent = 128 << 10;
void keepUnsentShort(int socket);

/// TCP only: the connection breaks when the other machine has acknowledged nothing for `limit`,
/// also of what the kernel asks it while there is nothing to send.
void breakWhenUnanswered(int socket, Duration limit);

}  // namespace suture::rpc
