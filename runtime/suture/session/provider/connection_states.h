#pragma once
// This tells tools how the required interfaces of a process are connected.

#include <suture/peer.capnp.h>
#include <suture/wiring/directory.h>

namespace suture {

/// Control thread. Adds to `out` the connections that the components of `directory` have at
/// present.
void tellConnections(const Directory& directory, wire::Peer::DescribeResults::Builder out);

}  // namespace suture
