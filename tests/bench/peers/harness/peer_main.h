#pragma once

#include <functional>
#include <memory>
#include <string>

#include "harness/peer.h"

namespace peers {

/// Makes the peer of that variant; nullptr if there is none.
using PeerOf = std::function<std::unique_ptr<Peer>(const std::string& variant)>;

/// Does what the main() of a peer's program does: one process of a measurement, as options.h says.
int peerMain(int count, char** arguments, const PeerOf& peerOf);

}  // namespace peers
