#pragma once
// This runs one process of a deployment.

#include <suture/component/factory/component_class.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/fault_handling.h>
#include <suture/deploy/message_listener.h>
#include <suture/deploy/process/components.h>
#include <suture/deploy/real_time.h>
#include <suture/manager/manager.h>

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// A Trouble is something that is wrong at present, while everything else keeps running.
struct Trouble {
  std::string subject;  ///< "connection 'left:Teleop/Slave -> right:PSM1/Arm'"
  std::string text;     ///< "is lost: the other process does not answer. Start it again"
  bool failure = true;  ///< false: the process does all that it is for
  bool loss = false;    ///< true: another process is lost, or this is due to that
  std::string more{};   ///< what has been found since: "cannot be made anew: ..."; "": nothing
};

/// One thread uses it, which is no task's. Holds the components, the manager and the connections of
/// one process.
class Host {
 public:
  /// Creates the components of `process`, as ProcessComponents does, and its manager. `deployment`
  /// outlives the host. Throws DocumentError with every problem of the components, or for keys and
  /// a policy that cannot be used, or a global manager that does not answer within `patience`.
  Host(const Deployment& deployment, std::string_view process,
       std::span<const ComponentClass> classes, Duration patience = Manager::kDefaultPatience);
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Before start(): adds a lane, as Manager::addLane() does, which the deployment may name. Throws
  /// SetupError.
  void addLane(std::unique_ptr<LaneKind> lane);
  /// Before start(): makes news() tell the standard messages of the components too. Throws
  /// SetupError.
  void listenToMessages();

  /// Configures and starts the components, then makes every connection that begins in this process,
  /// waiting at most `patience` for each other process. Throws DocumentError that names the
  /// component or the connection.
  void start();

  /// Any thread. Makes a start() that waits for another process throw now.
  void giveUp() { manager_->giveUp(); }

  /// Stops the components, collectors last, and ends all connections. Nothing starts again.
  void stop();

  const Manager& manager() const { return *manager_; }
  /// Returns the names of the components, in the order of the file.
  std::vector<std::string> componentNames() const;

  /// Returns connections whose far end is gone, components that are faulted for good, and a global
  /// manager that does not answer. What has recovered is missing at the next call. After stop()
  /// these are only the components that are faulted.
  std::vector<Trouble> troubles() const;
  /// Returns false if what one of troubles() was about is no more: a connection whose client has
  /// ended. So it has not recovered.
  bool exists(const Trouble& trouble) const;
  /// Returns what else has happened since the last call, a line each: what the machine does not
  /// grant, restarts after faults, files of the black box, tasks that wait for each other,
  /// messages.
  std::vector<std::string> news();
  /// Before the last news(): waits for the files of the black box.
  void endBlackBox() { faults_->end(); }

 private:
  void createManager();
  std::span<const std::unique_ptr<Component>> components() const { return components_->all(); }
  void requireLanes() const;
  void announceConnections();
  void configure();
  bool faultedForGood(const Component& component) const;
  std::vector<Trouble> componentTroubles() const;
  std::vector<Trouble> connectionTroubles() const;
  std::vector<std::string> mutualWaits();

  const Deployment& deployment_;
  const ProcessEntry& process_;
  const Duration patience_;
  bool stopped_ = false;
  std::set<std::string> toldToWait_;   // connections, each of which is told once
  std::vector<std::string> warnings_;  // what the start warned of, until news() has returned it
  RealTime realTime_{deployment_.document(), process_};  // locks what comes after it, too
  std::optional<ProcessComponents> components_;
  std::optional<MessageListener> messages_;
  std::unique_ptr<Manager> manager_;     // stops before the components go
  std::optional<FaultHandling> faults_;  // looks at components
};

}  // namespace suture
