#pragma once
// This makes a connected socket into a stream whose far end is known.

#include <suture/base/time.h>
#include <suture/loop/event_port.h>
#include <suture/net/address.h>
#include <suture/net/byte_stream.h>
#include <suture/net/tls/keys.h>
#include <suture/net/tls/session.h>
#include <suture/net/trust.h>

#include <memory>
#include <string>
#include <vector>

namespace suture::net {

/// Says why a peer may have closed a new connection without a word.
inline constexpr const char* kMayBeFull =
    "It may have reached its limit of links: see what it says.";

/// The control thread. Does the TLS handshake on a connected, non-blocking socket. Rejects with
/// what was found and what to do; gives up at `deadline` from now.
kj::Promise<ByteStream> handshake(loop::EventPort& port, kj::AutoCloseFd socket,
                                  std::shared_ptr<const tls::Keys> keys, tls::Session::Side side,
                                  Duration deadline);

/// The control thread. Returns a stream to the process `expected` at `address`. It is dialled and,
/// for tls://, has proved that it is that process; on a Unix socket, it has proved that a trusted
/// user runs it. Rejects with what was asked, what was found and what to do, as DISCONNECTED if
/// trying again may help. Waits for `limit` to be connected, and twice as long for the handshake of
/// TLS, which takes two round trips.
kj::Promise<ByteStream> reach(loop::EventPort& port, const Address& address, const Trust& trust,
                              const std::string& expected, Duration limit);

/// Does what reach() does, at the first of `places` that can be reached; they are all of one host.
/// `limit` holds for each of them.
kj::Promise<ByteStream> reachFirst(loop::EventPort& port, std::vector<Address> places,
                                   const Trust& trust, const std::string& expected, Duration limit);

/// Throws SetupError if `address` needs keys and there are none.
void requireKeys(const Address& address, const Trust& trust);

}  // namespace suture::net
