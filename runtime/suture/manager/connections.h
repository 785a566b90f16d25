#pragma once
// This connects the required interfaces of one process.

#include <suture/component/required.h>
#include <suture/session/connect_options.h>
#include <suture/session/service_threads.h>
#include <suture/wiring/directory.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

class Network;

/// The manager's thread uses it. A connection within the process is made here, any other by the
/// network. A required interface is named as in "Teleop/Slave".
class Connections {
 public:
  /// All outlive it. `network` is null in a process on its own, and as soon as it has been left.
  Connections(const Directory& directory, ServiceThreads& threads,
              const std::unique_ptr<Network>& network)
      : directory_(directory), threads_(threads), network_(network) {}

  /// Connects `required`, which others see as `from`. Throws a SetupError that says why not.
  void connect(RequiredBase& required, const Endpoint& from, std::string_view provided,
               const ConnectOptions& options);
  /// Takes a connection down, and tells the client. Throws SetupError if there is none.
  void disconnect(std::string_view required);
  /// Takes down a connection of which the client knows already that it ends.
  void drop(const std::string& required);
  /// Admits commands again. Throws SetupError if the connection awaits no operator.
  void resume(std::string_view required);

  /// Returns the connection of a required interface; nullptr: it has none.
  std::shared_ptr<Channel> of(const std::string& required) const;
  /// Returns every connection that has an end in this process.
  std::vector<std::shared_ptr<Channel>> all() const;

 private:
  void requireFree(const Endpoint& required, const std::string& connection) const;
  std::shared_ptr<Channel> connectHere(RequiredBase& required, ProvidedBase& provided,
                                       const std::string& connection,
                                       const ConnectOptions& options);

  const Directory& directory_;
  ServiceThreads& threads_;
  const std::unique_ptr<Network>& network_;
  std::map<std::string, std::shared_ptr<Channel>> local_;  // by required interface
  std::vector<std::shared_ptr<Channel>> offered_;          // the provider ends of delayed ones
};

}  // namespace suture
