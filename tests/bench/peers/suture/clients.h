#pragma once
// The harness calls these clients in the thread of the requester.

#include <memory>

#include "harness/peer.h"
#include "suture/components.h"

namespace peers {

enum class Back { AsEvent, AsReturnValue };

/// Makes the client for echoes and the stream. `requester` outlives it.
std::unique_ptr<Client> clientOfServer(Requester& requester, Back back);
/// Makes the client that publishes to all that are connected. `requester` outlives it.
std::unique_ptr<Client> publisher(Requester& requester);

}  // namespace peers
