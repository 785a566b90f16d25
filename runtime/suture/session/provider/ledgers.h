#pragma once
// These are the sums of all connections that peers have made to this process.

#include <suture/component/channel/counts/ledger.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace suture {

/// Belongs to the control thread. Names of connections are given here with who has proved to be
/// behind them. Peers choose them, so what is over is dropped beyond a bound.
class Ledgers {
 public:
  /// Returns the sums of the connection of that name with that start of its client's process; an
  /// attempt that is never accepted leaves nothing behind.
  std::shared_ptr<Ledger> of(const std::string& name, std::uint64_t client);
  /// Keeps the sums of a connection that has been accepted.
  void keep(const std::string& name, std::uint64_t client, std::shared_ptr<Ledger> ledger);

 private:
  struct Account {
    std::uint64_t client;  // the incarnation of its process
    std::shared_ptr<Ledger> ledger;
  };

  std::map<std::string, Account> accounts_;  // by connection
  std::map<std::pair<std::string, std::uint64_t>, std::weak_ptr<Ledger>> attempted_;
  Ledger::History history_ = Ledger::History::Whole;
};

}  // namespace suture
