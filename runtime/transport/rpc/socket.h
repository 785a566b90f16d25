#pragma once
// Sockets as the links want them.

#include <kj/io.h>
#include <suture/transport/rpc/address.h>

namespace suture::rpc {

/// An unconnected stream socket of the address's family: non-blocking, closed on exec. Throws
/// SetupError.
kj::AutoCloseFd openSocket(const Address& address);

/// TCP only: every send leaves at once.
void sendWithoutDelay(int socket);

}  // namespace suture::rpc
