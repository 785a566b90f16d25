#pragma once
// Makes connections.

#include <kj/async-unix.h>
#include <kj/io.h>
#include <suture/base/time.h>
#include <suture/transport/rpc/address.h>

namespace suture::rpc {

/// Control thread: a connected, non-blocking socket (TCP without delay), or a rejection that says
/// what was asked, what was found and what to do. Gives up at `deadline` from now.
kj::Promise<kj::AutoCloseFd> dial(kj::UnixEventPort& port, const Address& address,
                                  Duration deadline);

}  // namespace suture::rpc
