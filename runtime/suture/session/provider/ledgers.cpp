#include <suture/session/provider/ledgers.h>

namespace suture {
namespace {

constexpr std::size_t kMostAccounts = 1024;

}  // namespace

// Attempts that are under way at the same time share one ledger.
std::shared_ptr<Ledger> Ledgers::of(const std::string& name, std::uint64_t client) {
  const bool named = client != 0;  // else the process is too old to tell an incarnation
  const auto account = accounts_.find(name);
  if (named && account != accounts_.end() && account->second.client == client) {
    return account->second.ledger;
  }
  std::erase_if(attempted_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<Ledger>& attempted = attempted_[{name, client}];
  std::shared_ptr<Ledger> ledger = named ? attempted.lock() : nullptr;
  if (ledger == nullptr) ledger = std::make_shared<Ledger>(ConnectionEnd::Provider, history_);
  attempted = ledger;
  return ledger;
}

void Ledgers::keep(const std::string& name, std::uint64_t client, std::shared_ptr<Ledger> ledger) {
  if (accounts_.size() >= kMostAccounts && !accounts_.contains(name)) {
    history_ = Ledger::History::Forgotten;
    std::erase_if(accounts_, [](const auto& one) { return one.second.ledger.use_count() == 1; });
  }
  attempted_.erase({name, client});
  accounts_[name] = {client, std::move(ledger)};
}

}  // namespace suture
