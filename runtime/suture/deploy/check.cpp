#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/deploy/check.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/process/components.h>
#include <suture/deploy/process/security.h>
#include <suture/lane/delay/delay_thread.h>
#include <suture/lane/lane_refusals.h>
#include <suture/lane/lanes.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/names/peer_address.h>
#include <suture/net/address.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/frames.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace suture {
namespace {

/// A Station is one process, with its components.
struct Station {
  Station(const Deployment& deployment, const ProcessEntry& process,
          std::span<const ComponentClass> classes, std::vector<std::string>& problems)
      : entry(process), components(deployment, process, classes, problems) {}

  const ProcessEntry& entry;
  const ProcessComponents components;
};

/// Says what a connection is between. A device or a task may stand at either end.
struct Joined {
  const RequiredBase* required;
  const InterfaceInfo* provided;
  Frames framesOfProvided;
};

std::string counted(std::size_t number, const char* one, const char* several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

/// Returns none if they are no addresses, of which the deployment has told.
std::vector<net::Address> managersOf(const Deployment& deployment) {
  try {
    return net::parseAddresses(deployment.manager());
  } catch (const SetupError&) {
    return {};
  }
}

std::string nameOf(const ConnectionEntry& connection) {
  return connectionName(connection.from, connection.to);
}

class Check {
 public:
  Check(const Deployment& deployment, const AddedLanes& added, Checked& found)
      : deployment_(deployment), found_(found) {
    if (added == nullptr) return;
    for (auto& lane : added()) lanes_.push_back(std::move(lane));
  }

  void judge(const ProcessEntry& process, std::span<const ComponentClass> classes) {
    stations_.emplace_back(deployment_, process, classes, found_.problems);
    components_ += process.components.size();
    judgeAddress(process);
    try {
      securityOf(deployment_, process, found_.warnings);
    } catch (const DocumentError& error) {
      add(error.problems());
    }
  }

  /// Judges the connections between the processes that have been judged.
  void judgeConnections() {
    for (const ConnectionEntry& connection : deployment_.connections()) {
      const bool fromHere = stationOf(connection.from) != nullptr;
      connections_ += fromHere || stationOf(connection.to) != nullptr ? 1 : 0;
      if (fromHere) attempt(connection, [&] { requireLane(connection); });
      const std::optional<Joined> joined = join(connection);
      if (joined) judge(connection, *joined);
    }
  }

  std::string subject() const {
    return counted(stations_.size(), "process", "processes") + ", " +
           counted(components_, "component", "components") + " and " +
           counted(connections_, "connection", "connections");
  }

 private:
  /// Judges where the process would listen.
  void judgeAddress(const ProcessEntry& process) {
    for (const net::Address& manager : managersOf(deployment_)) {
      if (manager.kind != net::Address::Kind::Unix) continue;
      try {
        (void)net::SocketAddress(longestPeerAddress(manager, process.name));
      } catch (const SetupError& error) {
        add({deployment_.document().locate(process.pointer + "/name", error.what())});
      }
    }
  }

  const Station* stationOf(const Endpoint& end) const {
    const auto found = std::find_if(stations_.begin(), stations_.end(), [&](const Station& one) {
      return one.entry.name == end.process;
    });
    return found == stations_.end() ? nullptr : &*found;
  }

  /// Returns nullptr if it is not judged here, or cannot be created.
  const Component* componentAt(const Endpoint& end) const {
    const Station* const station = stationOf(end);
    if (station == nullptr) return nullptr;
    const auto& entries = station->entry.components;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].name == end.component) return station->components.all()[i].get();
    }
    return nullptr;
  }

  /// Returns nothing if one end is not there, of which the process of that end tells.
  std::optional<Joined> join(const ConnectionEntry& connection) const {
    const Component* const from = componentAt(connection.from);
    const Component* const to = componentAt(connection.to);
    if (from == nullptr || to == nullptr) return std::nullopt;
    const RequiredBase* const required = named(from->required(), connection.from.interface);
    if (required == nullptr) return std::nullopt;
    if (const ProvidedBase* const one = named(to->provided(), connection.to.interface)) {
      return Joined{required, &one->info(), one->frames()};
    }
    if (connection.to.interface != LifecycleInterface::kName) return std::nullopt;
    return Joined{required, &interfaceInfo<Lifecycle>(), {}};
  }

  template <class Interface>
  static const Interface* named(const std::vector<Interface*>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Interface* one) { return one->name() == name; });
    return found == all.end() ? nullptr : *found;
  }

  void judge(const ConnectionEntry& connection, const Joined& joined) {
    const std::string name = nameOf(connection);
    const InterfaceInfo& required = joined.required->info();
    const bool local =
        connection.from.process == connection.to.process && connection.options.lane == Lane::Auto;
    attempt(connection, [&] {
      (local ? requireSameContract : requireCompatibleContract)(required, *joined.provided, name);
    });
    attempt(connection,
            [&] { requireSameFrames(joined.required->frames(), joined.framesOfProvided, name); });
    if (connection.options.delay.any()) {
      attempt(connection, [&] { DelayThread::requireBounded(required); });
    }
    if (connection.options.laneRequired) judgeLane(connection, required, name);
  }

  // The process of a connection's client is the one that asks for its lane.
  void requireLane(const ConnectionEntry& connection) const {
    const Lane& lane = connection.options.lane;
    if (lane == Lane::Auto || findLane(lanes_, lane.name) != lanes_.end()) return;
    throw laneUnknown(nameOf(connection), lane, laneNames(lanes_));
  }

  void judgeLane(const ConnectionEntry& connection, const InterfaceInfo& contract,
                 const std::string& name) {
    const Lane& lane = connection.options.lane;
    const auto found = findLane(lanes_, lane.name);
    if (found == lanes_.end()) return;
    const std::string why = (*found)->whyNever(contract, areReachedByUnixSockets());
    if (why.empty()) return;
    add({deployment_.document().locate(connection.pointer, laneRefused(name, lane, why).what())});
  }

  /// Processes listen where their global manager does.
  bool areReachedByUnixSockets() const { return deployment_.manager().starts_with("unix:"); }

  template <class Work>
  void attempt(const ConnectionEntry& connection, const Work& work) {
    try {
      work();
    } catch (const SetupError& error) {
      add({deployment_.document().locate(connection.pointer, error.what())});
    }
  }

  void add(const std::vector<std::string>& problems) {
    found_.problems.insert(found_.problems.end(), problems.begin(), problems.end());
  }

  const Deployment& deployment_;
  Checked& found_;
  Lanes lanes_ = makeLanes();
  std::deque<Station> stations_;
  std::size_t components_ = 0, connections_ = 0;
};

/// Removes what several processes have told alike, such as a policy that none can read.
void tellOnce(std::vector<std::string>& lines) {
  std::vector<std::string> once;
  for (std::string& line : lines) {
    if (std::find(once.begin(), once.end(), line) == once.end()) once.push_back(std::move(line));
  }
  lines = std::move(once);
}

}  // namespace

Checked checkDeployment(const std::filesystem::path& file, const std::string& process,
                        std::span<const ComponentClass> classes, const AddedLanes& added) {
  Checked found;
  try {
    const Deployment deployment(JsonDocument::read(file), found.problems);
    Check check(deployment, added, found);
    if (process.empty()) {
      for (const ProcessEntry& one : deployment.processes()) check.judge(one, classes);
    } else {
      check.judge(deployment.process(process), classes);
    }
    check.judgeConnections();
    found.subject = check.subject();
  } catch (const DocumentError& error) {
    found.problems.insert(found.problems.end(), error.problems().begin(), error.problems().end());
  }
  tellOnce(found.problems);
  tellOnce(found.warnings);
  return found;
}

}  // namespace suture
