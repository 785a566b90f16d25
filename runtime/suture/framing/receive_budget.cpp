#include <suture/framing/receive_budget.h>

namespace suture::rpc {
namespace {

std::string beyond(const std::string& whose, std::size_t limit) {
  return "the unfinished messages of " + whose + " would need more than " + std::to_string(limit) +
         " bytes. Send smaller ones, or fewer at a time";
}

}  // namespace

std::optional<std::string> ReceiveBudget::Share::hold(std::size_t bytes) {
  if (bytes == held_) return std::nullopt;
  const auto peer = budget_->peers_.try_emplace(peer_, 0).first;
  const std::size_t ofPeer = peer->second - held_ + bytes;
  const std::size_t ofAll = budget_->held_ - held_ + bytes;
  if (bytes > held_) {
    const bool peerTooMuch = ofPeer > budget_->limits_.peer;
    if (peerTooMuch || ofAll > budget_->limits_.process) {
      if (peer->second == 0) budget_->peers_.erase(peer);
      return peerTooMuch ? beyond(peer_, budget_->limits_.peer)
                         : beyond("all peers", budget_->limits_.process);
    }
  }
  budget_->held_ = ofAll;
  held_ = bytes;
  peer->second = ofPeer;
  if (ofPeer == 0) budget_->peers_.erase(peer);
  return std::nullopt;
}

}  // namespace suture::rpc
