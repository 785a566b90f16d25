#pragma once
// This bounds how many there may be of what peers ask for, in all and of one peer.

#include <suture/net/peer_identity.h>
#include <suture/session/provider/limits/places.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace suture {

/// One thread asks and takes; any thread may give a place back. All peers with the same proof of
/// who they are count as one. By plain TCP nobody proves who he is, so only the bound of all holds.
class SharedPlaces {
 public:
  struct Limits {
    std::size_t all, ofOne;
  };

  explicit SharedPlaces(const Limits& limits) : limits_(limits), all_(limits.all) {}

  /// Returns why there is no place for `who`, in words that begin with "it has 1024 of them" or
  /// "512 of them are with"; or nothing if there is one.
  std::optional<std::string> whyNone(const net::PeerIdentity& who);
  /// Call it only when there is a free one.
  Places::Place take(const net::PeerIdentity& who);

 private:
  const Limits limits_;
  Places all_;
  std::map<std::string, Places> ofPeers_;  // by what they have proved
};

}  // namespace suture
