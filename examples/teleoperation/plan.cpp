#include "plan.h"

#include <suture/base/errors.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace demo {
namespace {

using nlohmann::json;
using suture::ComponentEntry;
using suture::ConnectionEntry;
using suture::ProcessEntry;

constexpr double kRateOfFiles = 1000;  // Hz, of whatever controls an arm

std::filesystem::path write(const Options& options, const std::filesystem::path& topologies,
                            const std::filesystem::path& folder) {
  json system = suture::JsonDocument::read(topologies / (options.topology + ".json")).value();
  system.erase("$schema");
  system.erase("manager");
  if (system.at("processes").size() > 1 || options.lane != "auto") {
    system["manager"] = "unix:" + (folder / "manager.sock").string();
  }
  for (json& process : system.at("processes")) {
    for (json& component : process.at("components")) {
      json& parameters = component.at("parameters");
      if (!parameters.contains("period")) continue;
      parameters["period"] = parameters["period"].get<double>() * kRateOfFiles / options.rate;
    }
  }
  for (json& connection : system.at("connections")) connection["lane"] = options.lane;
  auto file = folder / "deployment.json";
  std::ofstream(file) << system.dump(2) << '\n';
  return file;
}

std::string nameOf(const suture::Endpoint& endpoint) {
  return endpoint.process + ":" + endpoint.component;
}

Eigen::Vector3d vectorOf(const json& list) {
  const auto numbers = list.get<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

bool isArm(const ComponentEntry& component) {
  return component.className == "Mtm" || component.className == "Psm";
}

}  // namespace

std::vector<std::string> topologiesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Plan::Plan(const Options& options, const std::filesystem::path& topologies,
           const std::filesystem::path& folder)
    : file_(write(options, topologies, folder)), deployment_(suture::JsonDocument::read(file_)) {
  findArms();
  findFollowings(folder);
  findKnot(folder);
  findLanes();
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
                             this->component(slave).parameters.at("time_constant")});
    }
  }
}

void Plan::findKnot(const std::filesystem::path& folder) {
  const ComponentEntry* const guide = componentOfClass("KnotGuide");
  const ComponentEntry* const recorder = componentOfClass("KnotRecorder");
  if (guide == nullptr || recorder == nullptr) return;
  knot_ = {folder / recorder->parameters.at("file").get<std::string>(),
           vectorOf(guide->parameters.at("target")), vectorOf(guide->parameters.at("approach"))};
}

const ComponentEntry* Plan::componentOfClass(const std::string& name) const {
  for (const ProcessEntry& process : deployment_.processes()) {
    for (const ComponentEntry& component : process.components) {
      if (component.className == name) return &component;
    }
  }
  return nullptr;
}

void Plan::findLanes() {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    const char* const fastest = connection.from.process == connection.to.process ? "local" : "shm";
    const bool forced = connection.lane != suture::Lane::Auto;
    lanes_[connection.from.toString() + " -> " + connection.to.toString()] =
        forced ? toString(connection.lane) : fastest;
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

std::filesystem::path Plan::recordingOf(const std::string& provided) const {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.to.toString() != provided) continue;
    const ComponentEntry& client = component(nameOf(connection.from));
    if (client.className == "Recorder") return client.parameters.at("file").get<std::string>();
  }
  throw suture::SetupError("judging '" + provided + "'", "nothing in the deployment records it",
                           "Connect a Recorder to it in the topology's file");
}

}  // namespace demo
