#pragma once
// This decides where a process listens for its peers, and where it reaches them.

#include <suture/names/manager_link.h>
#include <suture/net/address.h>

#include <string>

namespace suture {

/// Returns the longest address that peerAddress() may return for a manager at this Unix socket: the
/// number of the process is part of it.
net::Address longestPeerAddress(const net::Address& manager, const std::string& process);

/// Returns an address next to the manager's: a socket in the same directory, or a free port at the
/// address by which this machine reaches it. Removes what dead processes of this name have left in
/// that directory, since a process that was killed cannot. It does not check how long the path is:
/// the listener refuses one that is too long.
net::Address peerAddress(const ManagerLink& link, const std::string& process);

/// Returns where a process is reached that the manager at that address knows. It is no less safe
/// than the link to the manager: what that has got from others does not lead out of TLS. Throws
/// SetupError.
net::Address addressOf(const ProcessRecord& process, const net::Address& manager);

}  // namespace suture
