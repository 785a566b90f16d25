#pragma once
// A process is this to its peers: an address at which they connect to its provided interfaces.

#include <suture/component/channel/counts/ledger.h>
#include <suture/framing/link_server.h>
#include <suture/lane/lanes.h>
#include <suture/loop/control_thread.h>
#include <suture/names/security.h>
#include <suture/peer.capnp.h>
#include <suture/session/network.h>
#include <suture/session/provider/awaited_sockets.h>
#include <suture/session/provider/places.h>
#include <suture/wiring/directory.h>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Listens and serves. Belongs to the control thread except where noted.
class PeerHost {
 public:
  /// Throws SetupError as LinkServer does.
  PeerHost(rpc::ControlThread& control, const Lanes& lanes, const Directory& directory,
           Network::ServerOf serverOf, Network::TaskOf taskOf, const rpc::Address& address,
           const Security& security, std::uint64_t incarnation);

  const rpc::Address& address() const { return server_->address(); }

  /// Says that all components are in the directory: what is not there now does not exist.
  void publish() { published_->fulfill(); }

  /// Listens no more, and ends all links; address() is gone. Cap'n Proto cancels the calls that
  /// wait here in the next turns of the loop, so this must live until then.
  void hangUp() { server_.reset(); }

  /// Any thread. Returns how many peers and requests this process has refused.
  rpc::Refusals::Summary refusals() const { return refusals_.summary(); }

  /// Any thread. Returns the provider ends of the connections that exist.
  std::vector<std::shared_ptr<Channel>> served() const;

 private:
  friend class PeerServer;

  /// Returns what serves a new link: this process, or the reason why not.
  capnp::Capability::Client offerTo(std::shared_ptr<rpc::Caller> caller);

  /// Describes the latest connection of a required interface of a peer. Names of clients and of
  /// connections are given here with who has proved to be behind them, since any peer may give
  /// them.
  struct Latest {
    std::string bootId;  // of the peer's machine, whose clock gave the epoch
    std::int64_t epoch;
    std::uint64_t incarnation;  // of the peer's process; 0: it does not say
    std::uint64_t greeting;     // which of all that this process has had began the session
    rpc::ProviderEnd* end;
  };

  std::uint64_t nextGreeting() { return ++greetings_; }
  /// Returns why the connection `name`, which has no end yet, may not take the place of the latest
  /// one of `client`; "" if it may.
  std::string whySuperseded(const std::string& client, const std::string& name,
                            const Latest& asked) const;
  /// Ends the latest connection, ahead of a later one.
  void endLatest(const std::string& client);
  void setLatest(const std::string& client, const Latest& latest) { latest_[client] = latest; }
  void forget(const rpc::ProviderEnd& end);

  /// Returns the sums of the connection of that name with that start of its client's process; an
  /// attempt that is never accepted leaves nothing behind.
  std::shared_ptr<Ledger> ledgerOf(const std::string& name, std::uint64_t client);
  /// Keeps the sums of a connection that has been accepted.
  void keepLedger(const std::string& name, std::uint64_t client, std::shared_ptr<Ledger> ledger);

  /// Adds to served(), and drops channels that have been closed.
  void remember(std::shared_ptr<Channel> channel);
  /// Drops the closed channels of a client that stays. The last ones of a client that leaves are
  /// kept for the reports until another client connects.
  void forgetClosed();

  rpc::ControlThread& control_;
  const Lanes& lanes_;
  const Directory& directory_;
  const Network::ServerOf serverOf_;
  const Network::TaskOf taskOf_;
  const std::uint64_t incarnation_;  // of this process
  const Policy policy_;
  kj::Own<kj::PromiseFulfiller<void>> published_;
  kj::ForkedPromise<void> whenPublished_;
  struct Account {
    std::uint64_t client;  // the incarnation of its process
    std::shared_ptr<Ledger> ledger;
  };
  std::map<std::string, Account> accounts_;  // by connection
  std::map<std::pair<std::string, std::uint64_t>, std::weak_ptr<Ledger>> attempted_;
  Ledger::History history_ = Ledger::History::Whole;
  std::map<std::string, Latest> latest_;  // by required interface, with its process
  std::uint64_t greetings_ = 0;
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Channel>> served_;
  AwaitedSockets sockets_;
  Places secondSockets_;  // of all sessions, those that are awaited included
  rpc::Refusals refusals_;
  std::optional<rpc::LinkServer> server_;  // last: its links use the rest
};

}  // namespace suture
