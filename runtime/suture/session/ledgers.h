#pragma once
// These are the sums of all connections that begin, or all that end, in this process.

#include <suture/component/channel/counts/ledger.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace suture {

/// Belongs to the control thread. A peer is who has proved to be behind a connection; it chooses
/// the names of connections. Those that begin here are of one peer without a name, as this process
/// chooses them. So beyond a bound for each peer, those sums are dropped whose connection was
/// accepted the longest time ago. From then on this process tells that peer no last counts for a
/// name that it does not know, because it may have known it. Other peers, and names that it knows,
/// notice nothing.
class Ledgers {
 public:
  /// `end` is the one that this process has.
  explicit Ledgers(ConnectionEnd end) : end_(end) {}

  static constexpr std::size_t kMostOfPeer = 1024;

  /// Returns the sums of the peer's connection of that name with that start of the client's
  /// process; an attempt that is never accepted leaves nothing behind.
  std::shared_ptr<Ledger> of(const std::string& peer, const std::string& name,
                             std::uint64_t client);
  /// Keeps the sums of a connection that has been accepted.
  void keep(const std::string& peer, const std::string& name, std::uint64_t client,
            std::shared_ptr<Ledger> ledger);
  /// Lets go of the memory of connections that have ended: only their sums are kept.
  void letGo();

 private:
  struct Account {
    std::uint64_t client;    // the incarnation of its process
    std::uint64_t accepted;  // which of all connections was the last one
    std::shared_ptr<Ledger> ledger;
  };
  struct Peer {
    std::map<std::string, Account> accounts;  // by connection
    Ledger::History history = Ledger::History::Whole;
  };
  static bool dropOldest(Peer& peer);

  const ConnectionEnd end_;
  std::map<std::string, Peer> peers_;
  std::map<std::tuple<std::string, std::string, std::uint64_t>, std::weak_ptr<Ledger>> attempted_;
  std::uint64_t accepted_ = 0;
};

}  // namespace suture
