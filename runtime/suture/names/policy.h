#pragma once
// This decides which peers may use which interface of a process.

#include <suture/net/peer_identity.h>
#include <suture/wiring/endpoint.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Says what a peer may do with an interface.
enum class Access : std::uint8_t {
  None,
  Read,  ///< reads, qualified reads, state and events; a command is refused: Errc::NotPermitted
  Full,
};

/// Says what the peers of this role may do. The patterns are "component/interface" or
/// "process:component/interface"; '*' stands for any characters.
struct Role {
  std::vector<std::string> full, read;
};

/// Says which peers have a role.
struct Rule {
  /// "process:console": who holds that certificate; '*' as above.
  /// "user:1000", "user:same": whose processes come over a Unix socket; same: this process's own
  /// user, or root.
  /// "tcp": whoever comes over plain TCP, without proof.
  std::string who;
  Role role;
};

/// Any thread. A Policy is that of one process, constant once made.
class Policy {
 public:
  /// Lets every peer that gets a link do everything: processes of the same user or with a
  /// certificate of the same CA, and on plain TCP all that reach the address.
  Policy() = default;
  /// The first rule for a peer counts; without a rule it may do nothing.
  explicit Policy(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  /// Returns true if the peer may do anything at all.
  bool admits(const net::PeerIdentity& peer) const;
  /// `provided` includes its process.
  Access access(const net::PeerIdentity& peer, const Endpoint& provided) const;
  /// Returns the users that rules name by number.
  std::vector<uid_t> users() const;

 private:
  const Role* roleOf(const net::PeerIdentity& peer) const;

  std::optional<std::vector<Rule>> rules_;
};

}  // namespace suture
