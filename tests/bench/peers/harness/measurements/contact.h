#pragma once
// A measurement begins when client and servers have found each other, and nothing is under way.

#include <memory>
#include <vector>

#include "harness/control_block.h"
#include "harness/peer.h"

namespace peers {

using Clients = std::vector<std::unique_ptr<Client>>;

/// Sends poses one way until each server has the last of them, and returns how many it has sent.
std::uint64_t reach(const Clients& clients, const ControlBlock& control, int servers);
/// Sends values there and back until the last of them is back.
void reachByEcho(Client& client, Pose first);
void reachByEcho(Client& client, Blob first);

}  // namespace peers
