#pragma once
// This is the identity of the peer at the other end of a link, as far as it can be proved.

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace suture::net {

/// A plain value holds what is known of a peer before it has said anything.
struct PeerIdentity {
  enum class Proof : std::uint8_t {
    None,         ///< plain TCP: it may be anybody who reaches the address
    User,         ///< a Unix socket: the kernel says whose process it is
    Certificate,  ///< TLS: it holds the key of a process's certificate
  };

  Proof proof = Proof::None;
  uid_t user = 0;       ///< User
  std::string process;  ///< Certificate

  /// Returns for example "process 'console'", "user 1000", or "a peer without proof of who it is
  /// (plain TCP)".
  std::string text() const;

  /// Returns true unless a certificate says that the peer is not the process `name`.
  bool mayBe(const std::string& name) const {
    return proof != Proof::Certificate || process == name;
  }
};

/// Returns what the kernel knows of the far end of a connected socket: the user of a Unix socket,
/// and nothing of others.
PeerIdentity identityOf(int socket);

/// Returns true if `user` is this process's user, root, or one of `others`.
bool isTrusted(uid_t user, const std::vector<uid_t>& others);

}  // namespace suture::net
