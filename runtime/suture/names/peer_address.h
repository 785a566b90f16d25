#pragma once
// This decides where a process listens for its peers, and where it reaches them.

#include <suture/names/manager_link.h>
#include <suture/net/address.h>

#include <cstdint>
#include <string>

namespace suture {

/// Returns the longest address that peerAddress() may return for a manager at this Unix socket: the
/// number of the process is part of it.
net::Address longestPeerAddress(const net::Address& manager, const std::string& process);

/// Returns what is asked for a process that is given a port: "give process 'arm' port 4101".
std::string portAsked(const std::string& process, std::uint16_t port);

/// Throws SetupError if `port` is not 0, and a process has none where the manager is.
void requireHasPorts(const net::Address& manager, const std::string& process, std::uint16_t port);

/// Returns an address next to the manager's: a socket in the same directory, or `port` at the
/// address by which this machine reaches it; 0 stands for a free one. Removes what dead processes
/// of this name have left in that directory, since a process that was killed cannot. It does not
/// check how long the path is: the listener refuses one that is too long.
net::Address peerAddress(const ManagerLink& link, const std::string& process, std::uint16_t port);

/// Returns where a process is reached that the manager at that address knows. It is no less safe
/// than the link to the manager: what that has got from others does not lead out of TLS. Throws
/// SetupError.
net::Address addressOf(const ProcessRecord& process, const net::Address& manager);

}  // namespace suture
