#pragma once
// This makes connections.

#include <kj/io.h>
#include <suture/base/time.h>
#include <suture/loop/event_port.h>
#include <suture/net/address.h>

namespace suture::net {

/// The control thread. Returns a connected, non-blocking socket (TCP without delay), or rejects
/// with what was asked, what was found and what to do. Gives up at `deadline` from now.
kj::Promise<kj::AutoCloseFd> dial(loop::EventPort& port, const Address& address, Duration deadline);

}  // namespace suture::net
