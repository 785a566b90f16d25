#pragma once
// This is the manager of one process: it has its components and their connections.

#include <suture/component/component.h>
#include <suture/manager/component_lives.h>
#include <suture/manager/connections.h>
#include <suture/net/refusals.h>
#include <suture/rt/scheduling.h>
#include <suture/session/connect_options.h>
#include <suture/session/service_threads.h>
#include <suture/session/telling.h>
#include <suture/wiring/directory.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace suture {

class HandleBase;
class LaneKind;
class Network;
struct Security;

/// One thread uses it, which is no task's. Adds components, connects their interfaces and leads
/// them through their lives. It does not own the components; those that have been started must
/// outlive it, or stop() comes first.
///
///   suture::Manager manager{"console", "unix:/tmp/suture.sock"};
///   manager.add("Teleop", teleop);
///   manager.start();
///   manager.connect("Teleop/Slave", "psm-host:PSM/Arm");
class Manager {
 public:
  static constexpr Duration kDefaultPatience = ConnectOptions::kDefaultPatience;

  /// Makes a process on its own.
  explicit Manager(std::string process);
  /// Makes a process that is known at the global manager at `address` ("unix:/path",
  /// "tls://host:port" or "tcp://host:port"), or at several
  /// ("tls://10.0.0.1:7700,tls://10.0.0.2:7700"), of which one must be alive. Throws SetupError if
  /// none answers there within `patience`, or if the name is taken.
  Manager(std::string process, const std::string& address, Duration patience = kDefaultPatience);
  /// Does the same with keys, which tls:// needs, or with a policy (suture/names/security.h).
  /// `port` is where other processes reach this one at tls:// and tcp://; 0: the kernel takes a
  /// free one. Throws SetupError also if the port is taken, or if `address` is a unix: one.
  Manager(std::string process, const std::string& address, const Security& security,
          Duration patience = kDefaultPatience, std::uint16_t port = 0);
  ~Manager();
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  /// Any thread. Returns the name of this process.
  const std::string& process() const { return directory_.process(); }

  /// `name` must be unique in this process. Gives the component its provided interface "component"
  /// (suture/standard/lifecycle.h). What is added after start() runs with the next start(). Throws
  /// SetupError.
  void add(const std::string& name, Component& component);

  /// Before start() and the first connection: gives `taker` the lines that it would print on
  /// standard error when a component faults or goes on, when a connection to another process is
  /// lost, there again, or cannot be made anew, and when its global manager is missing or there
  /// again; null: nobody is told. Several threads call it, also that of a task that has just
  /// faulted, so it must not wait.
  void tellBy(Telling::Taker taker) { telling_->giveTo(std::move(taker)); }

  /// Before start() and the first connection: sets the scheduling of the threads that carry
  /// connections and serve devices. Throws SetupError if the kernel refuses.
  void scheduleService(const rt::Scheduling& scheduling);

  /// Before start() and the first connection, in both processes: adds a lane
  /// (suture/lane/lane_kind.h), which carries the connections that ask for it by its name. Throws
  /// SetupError without a global manager, or if that name exists, or a connection to another
  /// process.
  void addLane(std::unique_ptr<LaneKind> lane);
  /// Returns the names of the lanes to another process, the fastest first and those that were added
  /// last; none without a global manager.
  std::vector<std::string> lanes() const;

  /// Configures the components that are not configured. One whose onConfigure() throws is parked.
  void configure();
  /// Configures, starts all components that do not run, and makes the provided interfaces known.
  /// Throws SetupError if a thread cannot have the scheduling that it asks for.
  void start();
  /// Waits until every component runs and every required interface that is not optional can reach
  /// its provider. Throws SetupError that names each that does not, and why, after `patience`, or
  /// as soon as a component has faulted.
  void awaitStart(Duration patience = kDefaultPatience) const;
  /// Waits until that component is suspended or running again. `component` is its name. Throws
  /// SetupError if there is none, if it is not running or not suspended, or if it does not get
  /// there within `patience`: its run() does not return, or no thread calls trigger().
  void suspend(const std::string& component, Duration patience = kDefaultPatience);
  /// Does the opposite under the same conditions.
  void resume(const std::string& component, Duration patience = kDefaultPatience);
  /// Any thread. Makes a connect() that waits for another process throw now, and later ones too,
  /// for a process that must end while it starts.
  void giveUp();
  /// Ends all connections and components. Those that provide Collecting (suture/standard) end last,
  /// so that they record what the others did to their end. The destructor does this too. Throws
  /// SetupError, and ends nothing, in the thread of a task of this process, which it would wait
  /// for. Throws it also, once all has ended, if the connections did not end in order.
  void stop();

  /// Before or after start(): connects a required interface of this process ("Teleop/Slave") to a
  /// provided one ("PSM/Arm", or "psm-host:PSM/Arm" of another process), or throws a SetupError
  /// that says why not.
  void connect(std::string_view required, std::string_view provided,
               const ConnectOptions& options = {});
  /// Does the same between the interfaces of two components that have been added here. It does not
  /// compile if the provider's contract neither is nor derives from the client's.
  ///   manager.connect(teleop.slave, psm.arm);
  template <class Client, class Contract>
  requires std::is_base_of_v<Client, Contract>
  void connect(Required<Client>& required, Provided<Contract>& provided,
               const ConnectOptions& options = {}) {
    connect(placeOf(required.owner(), required.name()), placeOf(provided.owner(), provided.name()),
            options);
  }
  /// Takes down the connection of a required interface of this process ("Teleop/Slave"), which may
  /// then be connected anew, while tasks run. It takes effect between two cycles of the client, and
  /// at once if that is a device or a task that does not run: calls under way end with
  /// Errc::OutcomeUnknown, and commands that the provider has not executed yet are dropped. Throws
  /// SetupError if it is not connected.
  void disconnect(std::string_view required);
  /// Admits commands again on a connection that awaits its operator. Throws SetupError if it is not
  /// connected, still lost, or awaits no operator.
  void resumeConnection(std::string_view required);

  /// Returns the components and interfaces of this process by name, for tools.
  const Directory& directory() const { return directory_; }
  /// Returns the address of the global manager while it does not answer or does not know this
  /// process, else ""; of several, those that do not, separated by commas. Connections live on
  /// without it, and it is asked again until it answers; only new connections have to wait, if no
  /// other manager answers.
  std::string missingGlobalManager() const;
  /// Returns by the address of each missing one why it is: "does not answer: ...", or
  /// "cannot be used: " and why, as when another process has taken the name of this one meanwhile.
  std::map<std::string, std::string> whyNoGlobalManager() const;
  /// Returns every connection that has an end in this process, as it is now: one that has been lost
  /// and made anew has another channel.
  std::vector<std::shared_ptr<Channel>> channels() const;
  /// Returns, by the name of the connection, why the provider in another process was lost last: it
  /// closed the connection, fell silent or hung. The reason stays when it is back, until
  /// disconnect().
  std::map<std::string, std::string> whyLost() const;
  /// Returns, by the name of the connection, why one that is lost cannot be made anew: its process
  /// is there and refuses it or does not answer. It is asked again and again all the same.
  std::map<std::string, std::string> whyNotBack() const;
  /// Returns a number that distinguishes this start of the process from all others; 0 without a
  /// global manager.
  std::uint64_t incarnation() const;
  /// Counts the peers and the requests of peers that this process has refused, and has the latest
  /// in words. Each was reported on standard error.
  net::Refusals::Summary refusals() const;

 private:
  friend class HandleBase;

  void connect(HandleBase& handle, RequiredBase& required, std::string_view provided,
               const ConnectOptions& options);
  void disconnect(HandleBase& handle);
  std::string placeOf(const Component& component, const std::string& interface) const;
  void refuseToStopInCycle() const;
  std::string stopAll();

  Directory directory_;
  const std::shared_ptr<const std::string> name_ = std::make_shared<std::string>(process());
  const std::shared_ptr<Telling> telling_ = std::make_shared<Telling>(process());
  ServiceThreads threads_;
  std::unique_ptr<Network> network_;
  Connections connections_{directory_, threads_, network_};
  ComponentLives lives_{directory_, connections_};
  std::vector<HandleBase*> handles_;
};

}  // namespace suture
