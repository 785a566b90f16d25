#pragma once
// This decides what a peer may ask of this process.

#include <capnp/common.h>
#include <suture/names/policy.h>
#include <suture/names/records.h>
#include <suture/net/peer_identity.h>
#include <suture/wiring/endpoint.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace suture {

/// Belongs to the control thread. Returns for each thing that a peer asks for why it may not have
/// it, or none.
class Admission {
 public:
  /// All of them outlive this.
  Admission(const std::string& process, const Policy& policy, const net::PeerIdentity& who)
      : process_(process), policy_(policy), who_(who) {}

  using Names = std::initializer_list<capnp::Text::Reader>;
  /// Bounds the names that the peer gives, because they are kept as long as its connections, and
  /// in their sums for longer.
  std::optional<Refusal> whyNotNames(Names names) const;
  /// Compares the version of the protocol that the peer speaks with ours.
  std::optional<Refusal> whyNotVersion(std::uint16_t theirs) const;
  /// Compares the name of its process with who the peer has proved to be.
  std::optional<Refusal> whyNotProcess(const std::string& name) const;
  std::optional<Refusal> whyNotInterface(const Endpoint& endpoint) const;
  bool mayOnlyRead(const Endpoint& endpoint) const;

  /// Returns a name that the peer gives, with who it has proved to be: others may give it too.
  std::string proven(const std::string& name) const { return who_.text() + ": " + name; }

 private:
  const std::string& process_;
  const Policy& policy_;
  const net::PeerIdentity& who_;
};

}  // namespace suture
