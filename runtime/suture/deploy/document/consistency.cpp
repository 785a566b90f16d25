#include <suture/base/nearest.h>
#include <suture/deploy/document/consistency.h>
#include <suture/deploy/document/entry_names.h>
#include <suture/names/peer_address.h>
#include <suture/net/address.h>

#include <algorithm>
#include <map>

namespace suture {
namespace {

class Consistency {
 public:
  Consistency(const Deployment& deployment, DocumentProblems& problems)
      : deployment_(deployment), problems_(problems) {}

  void checkNames();
  void checkSingleProviders();
  void checkManager();
  void checkPorts();

 private:
  void checkBlackBox(const ProcessEntry& process);
  void checkEndpoint(const Endpoint& endpoint, const std::string& pointer);
  void reportMissing(const ProcessEntry& process, const std::string& component,
                     const std::string& pointer);
  bool isOneMachine() const;

  const Deployment& deployment_;
  DocumentProblems& problems_;
};

void Consistency::checkNames() {
  for (std::size_t i = 0; i < deployment_.processes().size(); ++i) {
    const ProcessEntry& process = deployment_.processes()[i];
    if (findNamed(deployment_.processes(), process.name) != &process) {
      problems_.report("/processes/" + std::to_string(i) + "/name",
                       "there is another process '" + process.name + "'; give each its own name");
    }
    for (const ComponentEntry& component : process.components) {
      if (findNamed(process.components, component.name) != &component) {
        problems_.report(component.pointer + "/name",
                         "process '" + process.name + "' has another component '" + component.name +
                             "'; give each its own name");
      }
    }
    if (process.blackBox) checkBlackBox(process);
  }
  for (const ConnectionEntry& connection : deployment_.connections()) {
    checkEndpoint(connection.from, connection.pointer + "/from");
    checkEndpoint(connection.to, connection.pointer + "/to");
  }
}

void Consistency::checkBlackBox(const ProcessEntry& process) {
  const std::vector<std::string>& watched = process.blackBox->components;
  for (std::size_t i = 0; i < watched.size(); ++i) {
    const std::string pointer = process.blackBox->pointer + "/components/" + std::to_string(i);
    if (findNamed(process.components, watched[i]) == nullptr) {
      reportMissing(process, watched[i], pointer);
    } else if (std::find(watched.begin(), watched.end(), watched[i]) != watched.begin() + i) {
      problems_.report(pointer, "'" + watched[i] + "' is named twice; name it once");
    }
  }
}

void Consistency::checkEndpoint(const Endpoint& endpoint, const std::string& pointer) {
  if (endpoint.process.empty()) return;  // reported already
  const ProcessEntry* process = findNamed(deployment_.processes(), endpoint.process);
  if (process == nullptr) {
    const auto names = namesOf(deployment_.processes());
    problems_.report(pointer, "'" + endpoint.toString() + "' is in an unknown process '" +
                                  endpoint.process + "'; there are " + listNames(names) +
                                  suggestion(endpoint.process, names));
    return;
  }
  if (findNamed(process->components, endpoint.component) == nullptr) {
    reportMissing(*process, endpoint.component, pointer);
  }
}

void Consistency::reportMissing(const ProcessEntry& process, const std::string& component,
                                const std::string& pointer) {
  const auto names = namesOf(process.components);
  problems_.report(pointer, "process '" + process.name + "' has no component '" + component +
                                "'; it has " + listNames(names) + suggestion(component, names));
}

void Consistency::checkSingleProviders() {
  std::map<std::string, const ConnectionEntry*> first;
  for (const ConnectionEntry& connection : deployment_.connections()) {
    const auto [existing, added] = first.emplace(connection.from.toString(), &connection);
    if (added) continue;
    problems_.report(connection.pointer + "/from",
                     "'" + connection.from.toString() + "' is connected already, on line " +
                         std::to_string(deployment_.document().lineOf(existing->second->pointer)) +
                         ", to '" + existing->second->to.toString() +
                         "'; a required interface has one provider: remove one of the two");
  }
}

void Consistency::checkManager() {
  if (deployment_.manager().starts_with("tls://") && deployment_.keys().empty()) {
    problems_.report("/manager",
                     "'" + deployment_.manager() +
                         "' needs keys, and key 'keys' is missing; make them with suture keys "
                         "and give their folder, for example \"keys\": \"keys\"");
  }
  if (!deployment_.manager().empty()) return;
  if (deployment_.processes().size() > 1) {
    problems_.report(
        "", std::to_string(deployment_.processes().size()) +
                " processes need a global manager to find each other, and key 'manager' is "
                "missing; give its address, for example \"unix:/tmp/suture.sock\"");
  }
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.options.lane == Lane::Auto) continue;
    problems_.report(
        connection.pointer + "/lane",
        "lane \"" + toString(connection.options.lane) +
            "\" needs a global manager, and key 'manager' is missing; give its address, "
            "or use lane \"auto\"");
  }
}

// Where there are several machines, the file does not say which process runs where: then the kernel
// refuses a port that is taken.
void Consistency::checkPorts() {
  std::map<std::uint16_t, const ProcessEntry*> first;
  for (const ProcessEntry& process : deployment_.processes()) {
    if (process.port == 0) continue;
    const std::string where = process.pointer + "/port",
                      asked = portAsked(process.name, process.port);
    if (deployment_.manager().empty()) {
      problems_.report(where,
                       asked +
                           ": key 'manager' is missing, so no other process looks for it. Give its "
                           "address, for example \"tls://10.0.0.1:7700\", or leave the port out");
      continue;
    }
    try {
      requireHasPorts(net::parseAddresses(deployment_.manager()).front(), process.name,
                      process.port);
    } catch (const SetupError& error) {
      problems_.report(where, error.what());
      continue;
    }
    const auto [existing, added] = first.emplace(process.port, &process);
    if (added || !isOneMachine()) continue;
    problems_.report(
        where,
        asked + ": process '" + existing->second->name + "' has that port, on line " +
            std::to_string(deployment_.document().lineOf(existing->second->pointer + "/port")) +
            ", and one machine runs both: no other reaches " + deployment_.manager() +
            ". Give each its own port");
  }
}

bool Consistency::isOneMachine() const {
  const auto managers = net::parseAddresses(deployment_.manager());
  return std::all_of(managers.begin(), managers.end(),
                     [](const net::Address& one) { return one.isLoopback(); });
}

}  // namespace

void checkConsistency(const Deployment& deployment, DocumentProblems& problems) {
  Consistency consistency(deployment, problems);
  consistency.checkNames();
  consistency.checkSingleProviders();
  consistency.checkManager();
  if (problems.count() == 0) consistency.checkPorts();
}

}  // namespace suture
