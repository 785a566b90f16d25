#pragma once
// This is a process's part in the network: its control thread, the address where peers reach it,
// its name at the global manager, and its connections.

#include <kj/async.h>
#include <suture/lane/lanes.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/milestone.h>
#include <suture/names/security.h>
#include <suture/net/address.h>
#include <suture/net/refusals.h>
#include <suture/rt/scheduling.h>
#include <suture/session/connection_news.h>
#include <suture/session/ledgers.h>
#include <suture/session/planned_connection.h>
#include <suture/session/service_threads.h>
#include <suture/wiring/directory.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace suture {

class ManagerLink;
class PeerHost;
class RemoteConnection;
class Sessions;
class Telling;

/// The manager's thread uses it; all work happens on the control thread that it owns.
class Network {
 public:
  /// Listens, and registers the process at the global managers. `managerAddress` is one address or
  /// several, separated by commas. It listens at `port` of tls:// and tcp://; 0: at one that the
  /// kernel takes. `threads` serve its peers; they outlive it, and stop after leave(). `telling`
  /// outlives it too. Throws SetupError.
  Network(const Directory& directory, const std::string& managerAddress, ServiceThreads& threads,
          const Telling& telling, Duration patience, const Security& security = {},
          std::uint16_t port = 0);
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Before the first connection: sets the scheduling of the threads that carry connections. Throws
  /// SetupError if the kernel refuses.
  void schedule(const rt::Scheduling& scheduling);

  /// Call it before publish() and the first connection. Throws SetupError if there is one of that
  /// name, or a connection.
  void addLane(std::unique_ptr<LaneKind> lane);

  std::vector<std::string> lanes() const;

  /// Announces the components that are in the directory, and lets peers connect to them.
  void publish();

  /// Connects by way of the control link, also to this process itself. Throws SetupError.
  void connect(PlannedConnection planned);
  /// Any thread. Makes a connect() under way throw now, and later ones too.
  void giveUp();
  /// Takes down a connection made by connect(); after that the required interface is not attached
  /// again. `required` is like "Teleop/Slave".
  void disconnect(const std::string& required);

  /// Ends all connections and gives the name back; waits until the control thread has done that.
  /// Returns why it failed, in words; "" if it did not. The network's doorbell may still be rung
  /// until this is destroyed.
  std::string leave();

  /// Returns the addresses of the global managers that do not know this process.
  std::string missingManager() const;
  /// Returns by the address of each of them why not; see ManagerLease::trouble().
  std::map<std::string, std::string> managerTroubles() const;

  /// Tells what has become of the connections that this process has begun.
  const ConnectionNews& news() const { return news_; }
  /// Returns a number that distinguishes this start of the process from all others; never 0.
  std::uint64_t incarnation() const { return incarnation_; }
  /// Counts what this process has refused to peers.
  net::Refusals::Summary refusals() const;
  /// Returns the provider ends of what peers have connected to this process.
  std::vector<std::shared_ptr<Channel>> served() const;

 private:
  kj::Promise<void> join(Duration patience);
  std::unique_ptr<PeerHost> listen();
  std::string endThere();
  kj::Promise<void> tellIfLong(kj::Promise<void> awaited, const std::string& what);
  kj::Promise<void> untilGivenUp();
  /// Opens a connection that has been begun.
  kj::Promise<void> open(const std::string& required, const Endpoint& to, Duration patience);
  std::shared_ptr<Ledger> ledgerOf(const std::string& connection);
  void forget(const std::string& required);
  void tellOf(const std::string& connection, const std::string& what) const;

  const Directory& directory_;
  ServiceThreads& threads_;
  const Telling& telling_;
  const std::vector<net::Address> managers_;  // all of one kind
  const Security security_;
  const std::uint16_t port_;  // 0: the kernel takes one
  const std::uint64_t incarnation_;
  loop::ControlThread control_;
  Lanes lanes_ = makeLanes();
  std::unique_ptr<ManagerLink> link_;
  std::unique_ptr<Sessions> sessions_;
  std::unique_ptr<PeerHost> host_;
  std::unique_ptr<loop::Milestone> givenUp_;
  Ledgers ledgers_{ConnectionEnd::Client};
  std::map<std::string, std::unique_ptr<RemoteConnection>> connections_;  // by required interface
  ConnectionNews news_;
};

}  // namespace suture
