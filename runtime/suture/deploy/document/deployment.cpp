#include <suture/base/nearest.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/document/schema_check.h>
#include <suture/lane/lanes.h>
#include <suture/names/peer_address.h>
#include <suture/net/address.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace suture {
namespace {

using nlohmann::json;

template <class Entry>
std::vector<std::string> namesOf(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

template <class Entry>
const Entry* find(const std::vector<Entry>& entries, std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

std::map<std::string, Frames> framesOf(const json& component) {
  std::map<std::string, Frames> frames;
  const auto all = component.find("frames");
  if (all == component.end()) return frames;
  for (const auto& [interface, given] : all->items()) {
    frames[interface] = {given.value("reference", ""), given.value("moving", "")};
  }
  return frames;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& existing) {
  const std::string nearest = nearestName(name, existing);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace

Deployment::Deployment(JsonDocument document) : document_(std::move(document)) {
  readAll();
  if (!problems_.empty()) throw DocumentError(problems_);
}

Deployment::Deployment(JsonDocument document, std::vector<std::string>& problems)
    : document_(std::move(document)) {
  readAll();
  problems.insert(problems.end(), problems_.begin(), problems_.end());
}

void Deployment::readAll() {
  for (const JsonProblem& problem :
       checkSchema(document_.value(), json::parse(deploymentSchema()))) {
    report(problem.pointer, problem.text);
  }
  if (!problems_.empty()) throw DocumentError(problems_);
  readManager();
  readProcesses();
  readConnections();
  checkNames();
  checkSingleProviders();
  checkManager();
  if (problems_.empty()) checkPorts();
}

// The path of a socket counts from the folder of the file, like all paths in it.
void Deployment::readManager() {
  const auto given = document_.value().find("manager");
  if (given == document_.value().end()) return;
  try {
    for (net::Address address : net::parseAddresses(*given)) {
      if (address.kind == net::Address::Kind::Unix) address.path = besideIt(address.path).string();
      manager_ += (manager_.empty() ? "" : ",") + address.text();
    }
  } catch (const SetupError& error) {
    report("/manager", error.what());
    manager_ = *given;  // it is not missing
  }
}

void Deployment::readProcesses() {
  const json& processes = document_.value().at("processes");
  for (std::size_t i = 0; i < processes.size(); ++i) {
    const std::string pointer = "/processes/" + std::to_string(i);
    const json& given = processes[i];
    ProcessEntry process{.name = given.at("name"),
                         .components = {},
                         .blackBox = readBlackBox(given, pointer),
                         .scheduling = readScheduling(given, pointer),
                         .port = given.value("port", std::uint16_t{0}),
                         .lockMemory = given.value("lock_memory", false),
                         .realTimeRequired = given.value("real_time", "preferred") == "required",
                         .pointer = pointer};
    const json& components = given.at("components");
    for (std::size_t j = 0; j < components.size(); ++j) {
      process.components.push_back(
          readComponent(components[j], pointer + "/components/" + std::to_string(j)));
    }
    processes_.push_back(std::move(process));
  }
}

ComponentEntry Deployment::readComponent(const json& component, const std::string& pointer) {
  return {.name = component.at("name"),
          .className = component.at("class"),
          .sharedLibrary = besideIt(component.value("library", "")),
          .parameters = component.value("parameters", json::object()),
          .restart = readRestart(component, pointer),
          .scheduling = readScheduling(component, pointer),
          .frames = framesOf(component),
          .pointer = pointer};
}

std::filesystem::path Deployment::besideIt(const std::string& path) const {
  if (path.empty()) return {};
  return std::filesystem::path(document_.name()).parent_path() / path;
}

std::optional<RestartBudget> Deployment::readRestart(const json& component,
                                                     const std::string& pointer) {
  const auto given = component.find("restart");
  if (given == component.end()) return std::nullopt;
  const RestartBudget budget{.most = given->at("most"),
                             .per = readLength(*given, "per", "", pointer + "/restart")};
  if (budget.per == Duration{0}) return std::nullopt;  // that has been reported
  return budget;
}

std::optional<BlackBoxEntry> Deployment::readBlackBox(const json& process,
                                                      const std::string& pointer) {
  const auto given = process.find("black_box");
  if (given == process.end()) return std::nullopt;
  const std::string where = pointer + "/black_box";
  return BlackBoxEntry{.folder = besideIt(given->at("folder")),
                       .last = readLength(*given, "last", "10s", where),
                       .period = readLength(*given, "period", "10ms", where),
                       .rows = given->value("rows", 0u),
                       .components = given->value("components", std::vector<std::string>{}),
                       .pointer = where};
}

std::optional<rt::Scheduling> Deployment::readScheduling(const json& owner,
                                                         const std::string& pointer) {
  const auto given = owner.find("scheduling");
  if (given == owner.end()) return std::nullopt;
  rt::Scheduling scheduling;
  if (given->contains("processor")) scheduling.processor = given->at("processor");
  scheduling.priority = given->value("priority", 0);
  if (given->contains("policy")) {
    scheduling.policy = given->at("policy") == "fifo" ? rt::Policy::Fifo : rt::Policy::RoundRobin;
  }
  const bool prioritized = scheduling.policy != rt::Policy::Default;
  if (prioritized != (scheduling.priority != 0)) {
    report(pointer + "/scheduling",
           prioritized ? "a policy needs a priority; add for example \"priority\": 80"
                       : "a priority needs a policy; add for example \"policy\": \"fifo\"");
  }
  return scheduling;
}

void Deployment::readConnections() {
  const json connections = document_.value().value("connections", json::array());
  for (std::size_t i = 0; i < connections.size(); ++i) {
    const std::string pointer = "/connections/" + std::to_string(i);
    connections_.push_back({readEndpoint(connections[i], pointer, "from"),
                            readEndpoint(connections[i], pointer, "to"),
                            readOptions(connections[i], pointer), pointer});
  }
}

ConnectOptions Deployment::readOptions(const json& connection, const std::string& pointer) {
  const Lane lane{connection.value("lane", Lane::Auto.name)};
  const bool required = connection.value("lane_required", false);
  if (required && lane == Lane::Auto) {
    report(pointer + "/lane_required",
           "it requires a lane and names none; name one, for example \"lane\": \"" +
               laneNames(makeLanes()).front() + "\", or remove lane_required");
  }
  return {.lane = lane,
          .laneRequired = required,
          .delay = readDelay(connection, pointer),
          .contract = readContract(connection, pointer)};
}

ConnectionDelay Deployment::readDelay(const json& connection, const std::string& pointer) {
  ConnectionDelay delay{.faults = readFaults(connection, pointer)};
  const auto given = connection.find("delay");
  if (given == connection.end()) return delay;
  const std::string where = pointer + "/delay";
  if (given->is_string()) {
    delay.commands = delay.answers = readDuration(*given, where);
    return delay;
  }
  delay.commands = readDuration(given->value("commands", "0s"), where + "/commands");
  delay.answers = readDuration(given->value("answers", "0s"), where + "/answers");
  return delay;
}

FaultPlan Deployment::readFaults(const json& connection, const std::string& pointer) {
  const auto given = connection.find("faults");
  if (given == connection.end()) return {};
  FaultPlan plan;
  const auto length = [&](const char* key, Duration& value) {
    if (given->contains(key)) value = readDuration(given->at(key), pointer + "/faults/" + key);
  };
  plan.seed = given->value("seed", plan.seed);
  plan.loss = given->value("loss", plan.loss);
  plan.burst = given->value("burst", plan.burst);
  plan.burstLength = given->value("burst_length", plan.burstLength);
  plan.duplicate = given->value("duplicate", plan.duplicate);
  plan.reorder = given->value("reorder", plan.reorder);
  length("hold_back", plan.holdBack);
  plan.delay = given->value("delay", plan.delay);
  length("delay_length", plan.delayLength);
  plan.delayAgain = given->value("delay_again", plan.delayAgain);
  length("jitter", plan.jitter);
  plan.ordered = given->value("ordered", plan.ordered);
  plan.stall = given->value("stall", plan.stall);
  length("stall_length", plan.stallLength);
  return plan;
}

ConnectionContract Deployment::readContract(const json& connection, const std::string& pointer) {
  const auto given = connection.find("contract");
  if (given == connection.end()) return {};
  const std::string where = pointer + "/contract";
  static const std::map<std::string, Fallback> kFallbacks{{"hold", Fallback::Hold},
                                                          {"zero", Fallback::Zero},
                                                          {"last", Fallback::Last},
                                                          {"fault", Fallback::Fault}};
  return {.maxAge = readDuration(given->value("max_age", "0s"), where + "/max_age"),
          .deadline = readDuration(given->value("deadline", "0s"), where + "/deadline"),
          .onStale = kFallbacks.at(given->value("on_stale", "hold")),
          .onLoss = kFallbacks.at(given->value("on_loss", "hold")),
          .resume = given->value("resume", "automatic") == "operator" ? Resume::Operator
                                                                      : Resume::Automatic,
          .silence = readSilence(*given, where + "/silence")};
}

// Zero stands for the silence that is usual.
Duration Deployment::readSilence(const json& contract, const std::string& pointer) {
  constexpr Duration kShortest = ConnectionContract::kShortestSilence;
  const std::string text = contract.value("silence", "0s");
  const std::size_t before = problems_.size();
  const Duration silence = readDuration(text, pointer);
  if (silence != Duration{0} && silence < kShortest && problems_.size() == before) {
    report(pointer, "a longest silence of " + text +
                        " is too short for the heartbeats that have to fit into it; allow at "
                        "least " +
                        std::to_string(kShortest / std::chrono::milliseconds(1)) + "ms");
  }
  return silence;
}

// Reads a number and its unit, which the schema has checked.
Duration Deployment::readDuration(const std::string& text, const std::string& pointer,
                                  Duration longest) {
  static const std::map<std::string, double> kUnits{
      {"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}};
  char* unit = nullptr;
  const double count = std::strtod(text.c_str(), &unit);  // infinite if there are too many digits
  const double nanoseconds = count * kUnits.at(unit);
  if (nanoseconds > static_cast<double>(longest.count())) {
    report(pointer, "a time of " + text + " is longer than " +
                        std::to_string(longest / std::chrono::seconds(1)) +
                        "s, which is the longest; shorten it");
    return {};
  }
  return Duration(std::llround(nanoseconds));
}

Duration Deployment::readLength(const json& object, const char* key, const char* otherwise,
                                const std::string& pointer) {
  const std::string text = object.value(key, otherwise);
  const std::string where = pointer + "/" + key;
  const std::size_t before = problems_.size();
  const Duration length = readDuration(text, where, std::chrono::hours(24));
  if (length == Duration{0} && problems_.size() == before) {
    report(where, "a time of " + text + " is no time at all; give a longer one");
  }
  return length;
}

Endpoint Deployment::readEndpoint(const json& connection, const std::string& pointer,
                                  const char* end) {
  Endpoint endpoint = Endpoint::parse(connection.at(end).get<std::string>());
  if (endpoint.process.empty()) {
    if (processes_.size() == 1) {
      endpoint.process = processes_.front().name;
    } else {
      report(pointer + "/" + end, "'" + endpoint.toString() +
                                      "' does not say in which process; write \"" +
                                      processes_.front().name + ":" + endpoint.toString() +
                                      "\" or another of " + listNames(namesOf(processes_)));
    }
  }
  return endpoint;
}

void Deployment::checkNames() {
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    const ProcessEntry& process = processes_[i];
    if (find(processes_, process.name) != &process) {
      report("/processes/" + std::to_string(i) + "/name",
             "there is another process '" + process.name + "'; give each its own name");
    }
    for (const ComponentEntry& component : process.components) {
      if (find(process.components, component.name) != &component) {
        report(component.pointer + "/name", "process '" + process.name +
                                                "' has another component '" + component.name +
                                                "'; give each its own name");
      }
    }
    if (process.blackBox) checkBlackBox(process);
  }
  for (const ConnectionEntry& connection : connections_) {
    checkEndpoint(connection.from, connection.pointer + "/from");
    checkEndpoint(connection.to, connection.pointer + "/to");
  }
}

void Deployment::checkBlackBox(const ProcessEntry& process) {
  const std::vector<std::string>& watched = process.blackBox->components;
  for (std::size_t i = 0; i < watched.size(); ++i) {
    const std::string pointer = process.blackBox->pointer + "/components/" + std::to_string(i);
    if (find(process.components, watched[i]) == nullptr) {
      reportMissing(process, watched[i], pointer);
    } else if (std::find(watched.begin(), watched.end(), watched[i]) != watched.begin() + i) {
      report(pointer, "'" + watched[i] + "' is named twice; name it once");
    }
  }
}

void Deployment::checkEndpoint(const Endpoint& endpoint, const std::string& pointer) {
  if (endpoint.process.empty()) return;  // reported already
  const ProcessEntry* process = find(processes_, endpoint.process);
  if (process == nullptr) {
    const auto names = namesOf(processes_);
    report(pointer, "'" + endpoint.toString() + "' is in an unknown process '" + endpoint.process +
                        "'; there are " + listNames(names) + suggestion(endpoint.process, names));
    return;
  }
  if (find(process->components, endpoint.component) == nullptr) {
    reportMissing(*process, endpoint.component, pointer);
  }
}

void Deployment::reportMissing(const ProcessEntry& process, const std::string& component,
                               const std::string& pointer) {
  const auto names = namesOf(process.components);
  report(pointer, "process '" + process.name + "' has no component '" + component + "'; it has " +
                      listNames(names) + suggestion(component, names));
}

void Deployment::checkSingleProviders() {
  std::map<std::string, const ConnectionEntry*> first;
  for (const ConnectionEntry& connection : connections_) {
    const auto [existing, added] = first.emplace(connection.from.toString(), &connection);
    if (added) continue;
    report(connection.pointer + "/from",
           "'" + connection.from.toString() + "' is connected already, on line " +
               std::to_string(document_.lineOf(existing->second->pointer)) + ", to '" +
               existing->second->to.toString() +
               "'; a required interface has one provider: remove one of the two");
  }
}

void Deployment::checkManager() {
  if (manager_.starts_with("tls://") && keys().empty()) {
    report("/manager", "'" + manager_ +
                           "' needs keys, and key 'keys' is missing; make them with suture keys "
                           "and give their folder, for example \"keys\": \"keys\"");
  }
  if (!manager_.empty()) return;
  if (processes_.size() > 1) {
    report("", std::to_string(processes_.size()) +
                   " processes need a global manager to find each other, and key 'manager' is "
                   "missing; give its address, for example \"unix:/tmp/suture.sock\"");
  }
  for (const ConnectionEntry& connection : connections_) {
    if (connection.options.lane == Lane::Auto) continue;
    report(connection.pointer + "/lane",
           "lane \"" + toString(connection.options.lane) +
               "\" needs a global manager, and key 'manager' is missing; give its address, "
               "or use lane \"auto\"");
  }
}

bool Deployment::isOneMachine() const {
  const auto managers = net::parseAddresses(manager_);
  return std::all_of(managers.begin(), managers.end(),
                     [](const net::Address& one) { return one.isLoopback(); });
}

// Where there are several machines, the file does not say which process runs where: then the kernel
// refuses a port that is taken.
void Deployment::checkPorts() {
  std::map<std::uint16_t, const ProcessEntry*> first;
  for (const ProcessEntry& process : processes_) {
    if (process.port == 0) continue;
    const std::string where = process.pointer + "/port",
                      asked = portAsked(process.name, process.port);
    if (manager_.empty()) {
      report(where, asked +
                        ": key 'manager' is missing, so no other process looks for it. Give its "
                        "address, for example \"tls://10.0.0.1:7700\", or leave the port out");
      continue;
    }
    try {
      requireHasPorts(net::parseAddresses(manager_).front(), process.name, process.port);
    } catch (const SetupError& error) {
      report(where, error.what());
      continue;
    }
    const auto [existing, added] = first.emplace(process.port, &process);
    if (added || !isOneMachine()) continue;
    report(where, asked + ": process '" + existing->second->name + "' has that port, on line " +
                      std::to_string(document_.lineOf(existing->second->pointer + "/port")) +
                      ", and one machine runs both: no other reaches " + manager_ +
                      ". Give each its own port");
  }
}

const ProcessEntry& Deployment::process(std::string_view name) const {
  if (const ProcessEntry* process = find(processes_, name)) return *process;
  const auto names = namesOf(processes_);
  throw DocumentError(
      {document_.locate("/processes", "no process '" + std::string(name) + "' here; there are " +
                                          listNames(names) + suggestion(name, names))});
}

void Deployment::report(const std::string& pointer, const std::string& text) {
  problems_.push_back(document_.locate(pointer, text));
}

}  // namespace suture
