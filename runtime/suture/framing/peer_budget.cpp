#include <suture/framing/peer_budget.h>

namespace suture::framing {

std::optional<PeerBudget::Beyond> PeerBudget::Share::hold(std::size_t bytes) {
  if (bytes == held_) return std::nullopt;
  const std::lock_guard lock(budget_->mutex_);
  const auto peer = budget_->peers_.try_emplace(peer_, 0).first;
  const std::size_t others = peer->second - held_, all = budget_->held_ - held_;
  const Limits& most = budget_->limits_;
  if (bytes > held_) {
    const bool peerTooMuch = bytes > most.peer - others;
    if (peerTooMuch || bytes > most.process - all) {
      if (peer->second == 0) budget_->peers_.erase(peer);
      if (peerTooMuch) return Beyond{peer_, most.peer, most.peer - others};
      return Beyond{"all peers", most.process, most.process - all};
    }
  }
  budget_->held_ = all + bytes;
  held_ = bytes;
  peer->second = others + bytes;
  if (peer->second == 0) budget_->peers_.erase(peer);
  return std::nullopt;
}

std::string unfinishedBeyond(const PeerBudget::Beyond& beyond) {
  return "the unfinished messages of " + beyond.whose + " would need more than " +
         std::to_string(beyond.limit) + " bytes. Send smaller ones, or fewer at a time";
}

}  // namespace suture::framing
