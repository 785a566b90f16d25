#pragma once
// A process's part in the network: its control thread, the address where peers reach it, its name
// at the global manager, and its connections.

#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/lane/lane_kind.h>
#include <suture/names/security.h>
#include <suture/net/refusals.h>
#include <suture/rt/scheduling.h>
#include <suture/session/connect_options.h>
#include <suture/wiring/directory.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace suture {

class DelayThread;
class Task;

/// Used by the manager's thread; all work happens on the control thread that it owns.
class Network {
 public:
  /// Tells which doorbell and thread serve an interface for remote clients: the task's, or an
  /// executor's.
  using ServerOf = std::function<std::shared_ptr<rt::Doorbell>(ProvidedBase&)>;
  /// The task whose thread that is; nullptr: a device that no remote client has asked for yet.
  using TaskOf = std::function<const Task*(const Component&)>;

  /// Listens, and registers the process at the global managers. `managerAddress`: one or several,
  /// separated by commas. Throws SetupError.
  Network(const Directory& directory, const std::string& managerAddress, ServerOf serverOf,
          TaskOf taskOf, Duration patience, const Security& security = {});
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Before the first connection: schedules so the threads that carry connections. Throws
  /// SetupError if the kernel refuses.
  void schedule(const rt::Scheduling& scheduling);

  /// Before publish() and the first connection. Throws SetupError if there is one of that name.
  void addLane(std::unique_ptr<LaneKind> lane);

  /// Makes the directory's present components known, and lets peers connect to them.
  void publish();

  /// Connects by way of the control connection, also to this process itself. Throws SetupError.
  /// `delays`: what delays it; nullptr: nothing does.
  void connect(RequiredBase& required, const Endpoint& from, const Endpoint& to,
               const ConnectOptions& options, DelayThread* delays,
               std::shared_ptr<ConnectionWatch> watch);
  /// Any thread: a connect() under way throws now, and so do later ones.
  void giveUp();
  /// Takes down a connection made by connect(); from then on nobody attaches to the required
  /// interface any more. `required`: "Teleop/Slave".
  void disconnect(const std::string& required);

  /// Ends all connections and gives the name back. What rings the network's doorbell may still do
  /// so, until this is destroyed.
  void leave();

  /// The addresses of the global managers that do not answer.
  std::string missingManager() const;

  /// The client ends of what has been connected, by required interface ("Teleop/Slave").
  std::map<std::string, std::shared_ptr<Channel>> connected() const;
  /// Why each that has been lost was, the last time, in words, by the channel's name.
  std::map<std::string, std::string> whyLost() const;
  /// Tells this start of the process from all others; never 0.
  std::uint64_t incarnation() const;
  /// Counts what this process has refused to peers.
  rpc::Refusals::Summary refusals() const;
  /// The provider ends of what peers have connected to this process.
  std::vector<std::shared_ptr<Channel>> served() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace suture
