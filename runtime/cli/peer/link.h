#pragma once
// This is a link to another process.

#include <suture/base/time.h>
#include <suture/framing/link.h>
#include <suture/loop/event_port.h>
#include <suture/net/address.h>
#include <suture/net/secure.h>

#include <string>

namespace suture::cli {

/// Throws SetupError unless something listens there, with what was found and what to do.
void knock(loop::EventPort& loop, const net::Address& address, Duration limit);

/// This is a link with what proves who is at its other end.
struct Reached {
  kj::Own<framing::Link> link;
  std::string certificatesEnd;  ///< as ByteStream has it
};

/// Returns a link to the process `expected`, with proof that it is that one if the address asks for
/// it. Throws as knock() does.
Reached reach(loop::EventPort& loop, const net::Address& address, const net::Trust& trust,
              const std::string& expected, Duration limit);

}  // namespace suture::cli
