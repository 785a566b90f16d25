#include <suture/session/provider/limits/shared_places.h>

#include <utility>

namespace suture {

std::optional<std::string> SharedPlaces::whyNone(const net::PeerIdentity& who) {
  const auto own = ofPeers_.find(who.text());
  if (own != ofPeers_.end() && !own->second.anyFree()) {
    return std::to_string(limits_.ofOne) + " of them are with " + own->first +
           ", and no peer has more. End some of its processes.";
  }
  if (all_.anyFree()) return std::nullopt;
  return "it has " + std::to_string(limits_.all) +
         " of them, and no process has more. End some of its peers.";
}

Places::Place SharedPlaces::take(const net::PeerIdentity& who) {
  std::erase_if(ofPeers_, [](const auto& peer) { return peer.second.allFree(); });
  if (who.proof == net::PeerIdentity::Proof::None) return all_.take();
  const auto own = ofPeers_.try_emplace(who.text(), limits_.ofOne).first;
  return std::make_shared<std::pair<Places::Place, Places::Place>>(all_.take(), own->second.take());
}

}  // namespace suture
