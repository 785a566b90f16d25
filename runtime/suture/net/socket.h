#pragma once
// This opens and sets up sockets for links.

#include <kj/io.h>
#include <suture/base/time.h>
#include <suture/net/address.h>

namespace suture::net {

/// Returns an unconnected stream socket of the address's family: non-blocking, closed on exec.
/// Throws SetupError.
kj::AutoCloseFd openSocket(const Address& address);

/// For TCP only. Makes every send leave at once.
void sendWithoutDelay(int socket);

/// For TCP only. Makes the kernel take no more while this many bytes wait there to be sent for the
/// first time. What is written later waits behind them, so there should be few; the kernel's buffer
/// has megabytes.
inline constexpr int kMostUnsent = 128 << 10;
void keepUnsentShort(int socket);

/// For TCP only. Breaks the connection when the other machine has acknowledged nothing for `limit`,
/// including the kernel's own probes while there is nothing to send.
void breakWhenUnanswered(int socket, Duration limit);

}  // namespace suture::net
