#include <suture/session/ledgers.h>

namespace suture {

void Ledgers::letGo() {
  for (const auto& [peer, known] : peers_) {
    for (const auto& [name, account] : known.accounts) account.ledger->letGo();
  }
}

// Attempts that are under way at the same time share one ledger.
std::shared_ptr<Ledger> Ledgers::of(const std::string& peer, const std::string& name,
                                    std::uint64_t client) {
  letGo();
  const bool named = client != 0;  // else the process is too old to tell an incarnation
  auto history = Ledger::History::Whole;
  if (const auto known = peers_.find(peer); known != peers_.end()) {
    const auto account = known->second.accounts.find(name);
    const bool isKnown = account != known->second.accounts.end();
    if (named && isKnown && account->second.client == client) return account->second.ledger;
    if (!isKnown) history = known->second.history;
  }
  std::erase_if(attempted_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<Ledger>& attempted = attempted_[{peer, name, client}];
  std::shared_ptr<Ledger> ledger = named ? attempted.lock() : nullptr;
  if (ledger == nullptr) ledger = std::make_shared<Ledger>(end_, history);
  attempted = ledger;
  return ledger;
}

void Ledgers::keep(const std::string& peer, const std::string& name, std::uint64_t client,
                   std::shared_ptr<Ledger> ledger) {
  Peer& known = peers_[peer];
  while (known.accounts.size() >= kMostOfPeer && !known.accounts.contains(name)) {
    if (!dropOldest(known)) break;
  }
  attempted_.erase({peer, name, client});
  known.accounts[name] = {client, ++accepted_, std::move(ledger)};
}

// Returns false if all of them have channels, of which there cannot be many.
bool Ledgers::dropOldest(Peer& peer) {
  auto oldest = peer.accounts.end();
  for (auto one = peer.accounts.begin(); one != peer.accounts.end(); ++one) {
    if (one->second.ledger.use_count() > 1) continue;
    const bool isFirst = oldest == peer.accounts.end();
    if (isFirst || one->second.accepted < oldest->second.accepted) oldest = one;
  }
  if (oldest == peer.accounts.end()) return false;
  peer.history = Ledger::History::Forgotten;
  peer.accounts.erase(oldest);
  return true;
}

}  // namespace suture
