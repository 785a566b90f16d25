#include "run/plan.h"

#include <suture/base/errors.h>
#include <suture/deploy/keys_command.h>
#include <suture/rt/scheduling.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run/connection_name.h"
#include "run/stop.h"

namespace demo {
namespace {

namespace rt = suture::rt;

using nlohmann::json;
using suture::ComponentEntry;
using suture::ConnectionEntry;
using suture::ProcessEntry;

// In s: each teleoperation in the topologies' files has this period; arms and drives have a
// shorter one. A slower task, such as a camera, keeps its period: how old its data may be is in the
// file too, and does not follow the rate.
constexpr double kControlPeriod = 0.001;

void setRate(json& component, double rate) {
  const json::json_pointer period("/parameters/period");
  if (!component.contains(period) || component[period] > kControlPeriod) return;
  component[period] = component[period].get<double>() / kControlPeriod / rate;
}

void setDynamics(json& component, const std::string& dynamics) {
  const std::string kind = component.at("class");
  if (kind.ends_with("Drives")) component["parameters"]["dynamics"] = dynamics;
}

/// Without real-time priorities the permit of the emergency stop may be this old: on a busy machine
/// a thread may wait that long for its processor.
constexpr std::chrono::milliseconds kPatientPermit{250};

/// Removes from a process what the topology's file says of the scheduling of its threads, which
/// this user may not have, and lets its drives accept older permits.
void giveUpRealTime(json& process) {
  process.erase("scheduling");
  for (json& component : process.at("components")) {
    component.erase("scheduling");
    const json::json_pointer permit("/parameters/permit");
    if (component.contains(permit) && component[permit] > 0) {
      component[permit] = std::chrono::duration<double>(kPatientPermit).count();
    }
  }
}

/// Lets the contract of a connection that reads permits accept those that drives accept then.
void acceptOlderPermits(json& connection) {
  const json::json_pointer age("/contract/max_age");
  const bool readsPermits = connection.at("to").get<std::string>().ends_with("/Stop");
  if (readsPermits && connection.contains(age)) {
    connection[age] = std::to_string(kPatientPermit.count()) + "ms";
  }
}

void setStop(json& component, const Moment& stop) {
  if (component.at("class") != "Assistant") return;
  const auto seconds = [](suture::Duration duration) {
    return std::chrono::duration<double>(duration).count();
  };
  component["parameters"]["press_after"] = seconds(stop.at);
  component["parameters"]["release_after"] = seconds(stop.length);
}

/// Sets the lane of a connection, except between an arm and its drives, which exchange more than
/// all others and mostly within a process.
void setLane(json& connection, const std::string& lane) {
  if (!connection.at("to").get<std::string>().ends_with("/Drives")) connection["lane"] = lane;
}

/// Makes keys for all processes of a system in the run's folder.
void makeKeys(nlohmann::json& system, const std::filesystem::path& folder) {
  suture::KeysRequest request;
  for (const json& process : system.at("processes"))
    request.processes.push_back(process.at("name"));
  request.out = folder / "keys";
  suture::makeKeys(request);
  system["keys"] = "keys";
}

/// Keeps what the topology's file means by paths of its own folder, though the run has another.
/// Components still write the files that their parameters name to the folder of the run.
void keepPaths(json& system, const suture::Deployment& topology) {
  const auto keep = [&](json& owner, const char* key) {
    const auto path = owner.find(key);
    if (path != owner.end()) *path = topology.document().besideIt(*path).string();
  };
  keep(system, "keys");
  keep(system, "policy");
  for (json& process : system.at("processes")) {
    if (process.contains("black_box")) keep(process["black_box"], "folder");
    for (json& component : process.at("components")) keep(component, "library");
  }
}

std::filesystem::path write(const Options& options, const std::optional<Moment>& stop,
                            bool realTime, Network& network, const std::filesystem::path& topology,
                            const std::filesystem::path& folder) {
  // The file is checked before it is changed, so that a message names the topology's own file and
  // line.
  const suture::Deployment given(suture::JsonDocument::read(topology));
  json system = given.document().value();
  keepPaths(system, given);
  system.erase("$schema");
  system.erase("manager");
  if (system.at("processes").size() > 1 || options.lane != "auto") {
    network.open();
    system["manager"] = network.managerAddress(folder);
    if (network.needsKeys()) makeKeys(system, folder);
  }
  for (json& process : system.at("processes")) {
    if (!realTime) giveUpRealTime(process);
    for (json& component : process.at("components")) {
      setRate(component, options.rate);
      if (!options.dynamics.empty()) setDynamics(component, options.dynamics);
      if (stop) setStop(component, *stop);
    }
  }
  json& connections = *system.emplace("connections", json::array()).first;
  for (json& connection : connections) {
    setLane(connection, options.lane);
    if (!realTime) acceptOlderPermits(connection);
  }
  auto file = folder / "deployment.json";
  std::ofstream(file) << system.dump(2) << '\n';
  return file;
}

/// Returns why this demo may not have that priority; "" if it may.
std::string whyNotWith(int priority, RealTimeTurn& turn) {
  if (priority == 0) return "";
  if (!rt::grantedOf("the demo", {rt::Policy::Fifo, priority}).refusals.empty()) {
    return "this user may have no real-time priorities";
  }
  return turn.take() ? "" : "another demo has the real-time priorities of this machine";
}

/// Returns the highest priority in the file; 0 if it gives none.
int highestPriorityIn(const std::filesystem::path& topology) {
  const suture::Deployment deployment(suture::JsonDocument::read(topology));
  int highest = 0;
  const auto look = [&](const std::optional<rt::Scheduling>& scheduling) {
    if (scheduling) highest = std::max(highest, scheduling->priority);
  };
  for (const ProcessEntry& process : deployment.processes()) {
    look(process.scheduling);
    for (const ComponentEntry& component : process.components) look(component.scheduling);
  }
  return highest;
}

std::string nameOf(const suture::Endpoint& endpoint) {
  return endpoint.process + ":" + endpoint.component;
}

/// Returns true if nothing crosses the connection during the outage.
bool isCut(const ConnectionEntry& one, const CutOff& cutOff) {
  const bool isItsOwn = one.from.process == cutOff.process || one.to.process == cutOff.process;
  return isItsOwn && (cutOff.isFrozen || one.from.process != one.to.process);
}

/// Returns a parameter by which the run is judged. It cannot be left to the class's default, which
/// only the workstation knows.
template <class Value>
Value parameterOf(const ComponentEntry& component, const char* name) {
  try {
    return component.parameters.at(name).get<Value>();
  } catch (const json::exception&) {
    throw suture::SetupError(
        "reading parameter '" + std::string(name) + "' of component '" + component.name + "'",
        "the topology's file leaves it out, or gives it another type",
        "State it there as the class declares it, for the run is judged by it");
  }
}

/// Returns by how much drives declare that their joints trail. Drives that move bodies with mass
/// declare no time constant: what their controllers leave is an error. Each cycle of the drives
/// measures, and begins to act on the goal that the arm made of the measurement before.
robots::DeclaredLag lagOf(const ComponentEntry& drives) {
  const auto dynamics = drives.parameters.find("dynamics");
  const bool haveMass = dynamics != drives.parameters.end() && *dynamics == "RigidBody";
  return {.time_constant = haveMass ? 0 : parameterOf<double>(drives, "time_constant"),
          .delay = parameterOf<double>(drives, "period")};
}

Eigen::Vector3d vectorOf(const ComponentEntry& component, const char* name) {
  return Eigen::Vector3d(parameterOf<std::array<double, 3>>(component, name).data());
}

bool isDriver(const ComponentEntry& component) {
  return component.className == "Teleop" || component.className == "KnotGuide";
}

bool isArm(const ComponentEntry& component) {
  return component.className == "Mtm" || component.className == "Psm";
}

}  // namespace

suture::Duration lengthOf(const Options& options) {
  return std::chrono::duration_cast<suture::Duration>(
      std::chrono::duration<double>(options.seconds));
}

Plan::Plan(const Options& options, Network& network, const std::filesystem::path& topology,
           const std::filesystem::path& folder)
    : name_(topology.stem()),
      stop_(parseStop(options.stop, lengthOf(options))),
      whyNotRealTime_(whyNotWith(highestPriorityIn(topology), turn_)),
      folder_(folder),
      file_(write(options, stop_, whyNotRealTime_.empty(), network, topology, folder)),
      deployment_(suture::JsonDocument::read(file_)) {
  findArms();
  findFollowings(folder);
  findKnot(folder);
  findLanes(network.fastestLane());
  findPermit();
}

void Plan::setManager(const std::string& address) {
  json system = deployment_.document().value();
  system["manager"] = address;
  std::ofstream(file_) << system.dump(2) << '\n';
  deployment_ = suture::Deployment(suture::JsonDocument::read(file_));
}

/// Returns true if the arm and its drives need a connection for power that is cut.
bool Plan::armDependsOn(const std::string& arm, const CutOff& cutOff) const {
  const std::string drives = connectedTo(arm + "/Drives");
  const auto& all = deployment_.connections();
  return std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
    const bool isTheirs = nameOf(one.from) == arm || nameOf(one.from) == drives;
    const bool isForPower = one.from.interface == "Drives" || one.from.interface == "Stop";
    return isTheirs && isForPower && isCut(one, cutOff);
  });
}

/// Returns true if a connection of the component that drives the slave is cut, or if one of its
/// arms has no power without the process: it drives only while all of them are up.
bool Plan::dependsOn(const std::string& slave, const CutOff& cutOff) const {
  if (armDependsOn(slave, cutOff)) return true;
  const auto& all = deployment_.connections();
  return std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& drive) {
    if (drive.to.toString() != slave + "/Arm" || !isDriver(component(nameOf(drive.from)))) {
      return false;
    }
    return std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
      if (nameOf(one.from) != nameOf(drive.from)) return false;
      const std::string provider = nameOf(one.to);
      return isCut(one, cutOff) || (isArm(component(provider)) && armDependsOn(provider, cutOff));
    });
  });
}

std::vector<RecordedSlave> Plan::judgedSlaves() const {
  return slavesOf([&](const std::string& slave) {
    return isDriven(slave) || recorderOf(slave + "/Arm") != nullptr;
  });
}

std::vector<RecordedSlave> Plan::slaves() const {
  return slavesOf([](const std::string&) { return true; });
}

std::vector<RecordedSlave> Plan::slavesThatDependOn(const CutOff& cutOff) const {
  return slavesOf([&](const std::string& slave) { return dependsOn(slave, cutOff); });
}

template <class Chosen>
std::vector<RecordedSlave> Plan::slavesOf(const Chosen& chosen) const {
  std::vector<RecordedSlave> slaves;
  for (const std::string& arm : arms_) {
    if (component(arm).className != "Psm" || !chosen(arm)) continue;
    slaves.push_back({arm, folder_ / recordingOf(arm + "/Arm")});
  }
  return slaves;
}

void Plan::findArms() {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (isArm(component)) arms_.push_back(process.name + ":" + component.name);
    }
  }
}

void Plan::findFollowings(const std::filesystem::path& folder) {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (component.className != "Teleop") continue;
      const std::string teleop = process.name + ":" + component.name;
      const std::string master = connectedTo(teleop + "/Master");
      const std::string slave = connectedTo(teleop + "/Slave");
      followings_.push_back({master, slave, teleop, folder / recordingOf(master + "/Arm"),
                             folder / recordingOf(slave + "/Arm"),
                             folder / recordingOf(teleop + "/Teleoperation"),
                             lagOf(this->component(connectedTo(slave + "/Drives")))});
    }
  }
}

void Plan::findKnot(const std::filesystem::path& folder) {
  const ComponentEntry* const guide = componentOfClass("KnotGuide");
  const ComponentEntry* const recorder = componentOfClass("KnotRecorder");
  if (guide == nullptr || recorder == nullptr) return;
  knot_ = {folder / parameterOf<std::string>(*recorder, "file"), vectorOf(*guide, "target"),
           robots::KnotBounds{.approach = vectorOf(*guide, "approach"),
                              .radius = parameterOf<double>(*guide, "radius"),
                              .slope = parameterOf<double>(*guide, "slope"),
                              .separation = parameterOf<double>(*guide, "separation")},
           parameterOf<bool>(*guide, "fixtures")};
}

const ComponentEntry* Plan::componentOfClass(const std::string& name) const {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (component.className == name) return &component;
    }
  }
  return nullptr;
}

void Plan::findLanes(const char* fastestLane) {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    const bool within = connection.from.process == connection.to.process;
    const char* const fastest = within ? "local" : fastestLane;
    const bool forced = connection.options.lane != suture::Lane::Auto;
    lanes_[nameOf(connection)] = forced ? toString(connection.options.lane) : fastest;
  }
}

void Plan::findPermit() {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (!component.parameters.contains("permit")) continue;
      const std::chrono::duration<double> seconds(parameterOf<double>(component, "permit"));
      permit_ = std::chrono::duration_cast<suture::Duration>(seconds);
    }
  }
}

const ComponentEntry& Plan::component(const std::string& name) const {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (process.name + ":" + component.name == name) return component;
    }
  }
  throw suture::SetupError("judging '" + name + "'", "the deployment has no such component",
                           "Correct the topology's file");
}

std::string Plan::connectedTo(const std::string& required) const {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.from.toString() == required) return nameOf(connection.to);
  }
  throw suture::SetupError("judging '" + required + "'", "the deployment does not connect it",
                           "Connect it in the topology's file");
}

bool Plan::isDriven(const std::string& slave) const {
  const auto& all = deployment_.connections();
  return std::any_of(all.begin(), all.end(), [&](const ConnectionEntry& one) {
    return one.to.toString() == slave + "/Arm" && isDriver(component(nameOf(one.from)));
  });
}

const ComponentEntry* Plan::recorderOf(const std::string& provided) const {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.to.toString() != provided) continue;
    const ComponentEntry& client = component(nameOf(connection.from));
    if (client.className == "Recorder") return &client;
  }
  return nullptr;
}

std::filesystem::path Plan::recordingOf(const std::string& provided) const {
  const ComponentEntry* const recorder = recorderOf(provided);
  if (recorder != nullptr) return parameterOf<std::string>(*recorder, "file");
  throw suture::SetupError("judging '" + provided + "'", "nothing in the deployment records it",
                           "Connect a Recorder to it in the topology's file");
}

}  // namespace demo
