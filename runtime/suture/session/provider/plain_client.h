#pragma once
// This serves a plain Cap'n Proto client, which knows nothing of lanes, as that of a connection by
// calls.

#include <capnp/capability.h>
#include <suture/peer.capnp.h>
#include <suture/session/provider/connections/held_connections.h>
#include <suture/session/provider/served_peer.h>

namespace suture {

using OpenContext = capnp::CallContext<wire::Peer::OpenParams, wire::Peer::OpenResults>;

/// Belongs to the control thread. Answers with the interface that the peer asks for, or refuses it.
/// `peer` and `held` outlive the promise.
kj::Promise<void> openForPlainClient(ServedPeer& peer, HeldConnections& held, OpenContext context);

}  // namespace suture
