#include <suture/base/nearest.h>
#include <suture/deploy/document/deployment_reader.h>
#include <suture/lane/lanes.h>
#include <suture/net/address.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace suture {
namespace {

using nlohmann::json;

std::map<std::string, Frames> framesOf(const json& component) {
  std::map<std::string, Frames> frames;
  const auto all = component.find("frames");
  if (all == component.end()) return frames;
  for (const auto& [interface, given] : all->items()) {
    frames[interface] = {given.value("reference", ""), given.value("moving", "")};
  }
  return frames;
}

}  // namespace

// The path of a socket counts from the folder of the file, like all paths in it.
std::string DeploymentReader::manager() {
  const auto given = document_.value().find("manager");
  if (given == document_.value().end()) return "";
  std::string manager;
  try {
    for (net::Address address : net::parseAddresses(*given)) {
      if (address.kind == net::Address::Kind::Unix) {
        address.path = document_.besideIt(address.path).string();
      }
      manager += (manager.empty() ? "" : ",") + address.text();
    }
    return manager;
  } catch (const SetupError& error) {
    problems_.report("/manager", error.what());
    return *given;  // it is not missing
  }
}

std::vector<ProcessEntry> DeploymentReader::processes() {
  std::vector<ProcessEntry> processes;
  for (const json& given : document_.value().at("processes")) {
    const std::string pointer = "/processes/" + std::to_string(processes.size());
    ProcessEntry process{.name = given.at("name"),
                         .components = {},
                         .blackBox = readBlackBox(given, pointer),
                         .scheduling = readScheduling(given, pointer),
                         .port = given.value("port", std::uint16_t{0}),
                         .peerMemory = readPeerMemory(given, pointer),
                         .lockMemory = given.value("lock_memory", false),
                         .realTimeRequired = given.value("real_time", "preferred") == "required",
                         .pointer = pointer};
    const json& components = given.at("components");
    for (std::size_t j = 0; j < components.size(); ++j) {
      process.components.push_back(
          readComponent(components[j], pointer + "/components/" + std::to_string(j)));
    }
    processes.push_back(std::move(process));
  }
  return processes;
}

framing::PeerBudget::Limits DeploymentReader::readPeerMemory(const json& process,
                                                             const std::string& pointer) {
  framing::PeerBudget::Limits limits = Security::kConnectionMemory;
  const auto given = process.find("peer_memory");
  if (given == process.end()) return limits;
  constexpr std::size_t kMebibyte = std::size_t{1} << 20;
  const auto read = [&](const char* name, std::size_t& bytes) {
    bytes = given->value(name, bytes / kMebibyte) * kMebibyte;
  };
  read("of_all", limits.process);
  if (!given->contains("of_one")) limits.peer = std::min(limits.peer, limits.process);
  read("of_one", limits.peer);
  if (limits.peer > limits.process) {
    problems_.report(pointer + "/peer_memory",
                     "one peer may take " + std::to_string(limits.peer / kMebibyte) +
                         " MiB for its connections, and all together only " +
                         std::to_string(limits.process / kMebibyte) +
                         " MiB; let \"of_one\" be at most \"of_all\"");
  }
  return limits;
}

ComponentEntry DeploymentReader::readComponent(const json& component, const std::string& pointer) {
  return {.name = component.at("name"),
          .className = component.at("class"),
          .sharedLibrary = document_.besideIt(component.value("library", "")),
          .parameters = component.value("parameters", json::object()),
          .restart = readRestart(component, pointer),
          .scheduling = readScheduling(component, pointer),
          .frames = framesOf(component),
          .pointer = pointer};
}

std::optional<RestartBudget> DeploymentReader::readRestart(const json& component,
                                                           const std::string& pointer) {
  const auto given = component.find("restart");
  if (given == component.end()) return std::nullopt;
  const RestartBudget budget{.most = given->at("most"),
                             .per = readLength(*given, "per", "", pointer + "/restart")};
  if (budget.per == Duration{0}) return std::nullopt;  // that has been reported
  return budget;
}

std::optional<BlackBoxEntry> DeploymentReader::readBlackBox(const json& process,
                                                            const std::string& pointer) {
  const auto given = process.find("black_box");
  if (given == process.end()) return std::nullopt;
  const std::string where = pointer + "/black_box";
  return BlackBoxEntry{.folder = document_.besideIt(given->at("folder")),
                       .last = readLength(*given, "last", "10s", where),
                       .period = readLength(*given, "period", "10ms", where),
                       .rows = given->value("rows", 0u),
                       .components = given->value("components", std::vector<std::string>{}),
                       .pointer = where};
}

std::optional<rt::Scheduling> DeploymentReader::readScheduling(const json& owner,
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
    problems_.report(pointer + "/scheduling",
                     prioritized
                         ? "a policy needs a priority; add for example \"priority\": 80"
                         : "a priority needs a policy; add for example \"policy\": \"fifo\"");
  }
  return scheduling;
}

std::vector<ConnectionEntry> DeploymentReader::connections() {
  std::vector<ConnectionEntry> connections;
  const json all = document_.value().value("connections", json::array());
  for (const json& given : all) {
    const std::string pointer = "/connections/" + std::to_string(connections.size());
    connections.push_back({readEndpoint(given, pointer, "from"), readEndpoint(given, pointer, "to"),
                           readOptions(given, pointer), pointer});
  }
  return connections;
}

Endpoint DeploymentReader::readEndpoint(const json& connection, const std::string& pointer,
                                        const char* end) {
  Endpoint endpoint = Endpoint::parse(connection.at(end).get<std::string>());
  if (!endpoint.process.empty()) return endpoint;
  std::vector<std::string> processes;
  for (const json& process : document_.value().at("processes")) {
    processes.push_back(process.at("name"));
  }
  if (processes.size() == 1) {
    endpoint.process = processes.front();
  } else {
    problems_.report(pointer + "/" + end, "'" + endpoint.toString() +
                                              "' does not say in which process; write \"" +
                                              processes.front() + ":" + endpoint.toString() +
                                              "\" or another of " + listNames(processes));
  }
  return endpoint;
}

ConnectOptions DeploymentReader::readOptions(const json& connection, const std::string& pointer) {
  const Lane lane{connection.value("lane", Lane::Auto.name)};
  const bool required = connection.value("lane_required", false);
  if (required && lane == Lane::Auto) {
    problems_.report(pointer + "/lane_required",
                     "it requires a lane and names none; name one, for example \"lane\": \"" +
                         laneNames(makeLanes()).front() + "\", or remove lane_required");
  }
  return {.lane = lane,
          .laneRequired = required,
          .delay = readDelay(connection, pointer),
          .contract = readContract(connection, pointer)};
}

ConnectionDelay DeploymentReader::readDelay(const json& connection, const std::string& pointer) {
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

FaultPlan DeploymentReader::readFaults(const json& connection, const std::string& pointer) {
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

ConnectionContract DeploymentReader::readContract(const json& connection,
                                                  const std::string& pointer) {
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

// Zero stands for the silence that is usual. That is stated here, because a contract without any
// term would be none, and the file has one.
Duration DeploymentReader::readSilence(const json& contract, const std::string& pointer) {
  constexpr Duration kShortest = ConnectionContract::kShortestSilence;
  const std::string text = contract.value("silence", "0s");
  const std::size_t before = problems_.count();
  const Duration silence = readDuration(text, pointer);
  if (silence != Duration{0} && silence < kShortest && problems_.count() == before) {
    problems_.report(pointer,
                     "a longest silence of " + text +
                         " is too short for the heartbeats that have to fit into it; allow at "
                         "least " +
                         std::to_string(kShortest / std::chrono::milliseconds(1)) + "ms");
  }
  return silence == Duration{0} ? ConnectionContract::kDefaultSilence : silence;
}

// Reads a number and its unit, which the schema has checked.
Duration DeploymentReader::readDuration(const std::string& text, const std::string& pointer,
                                        Duration longest) {
  static const std::map<std::string, double> kUnits{
      {"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}};
  char* unit = nullptr;
  const double count = std::strtod(text.c_str(), &unit);  // infinite if there are too many digits
  const double nanoseconds = count * kUnits.at(unit);
  if (nanoseconds > static_cast<double>(longest.count())) {
    problems_.report(pointer, "a time of " + text + " is longer than " +
                                  std::to_string(longest / std::chrono::seconds(1)) +
                                  "s, which is the longest; shorten it");
    return {};
  }
  return Duration(std::llround(nanoseconds));
}

Duration DeploymentReader::readLength(const json& object, const char* key, const char* otherwise,
                                      const std::string& pointer) {
  const std::string text = object.value(key, otherwise);
  const std::string where = pointer + "/" + key;
  const std::size_t before = problems_.count();
  const Duration length = readDuration(text, where, std::chrono::hours(24));
  if (length == Duration{0} && problems_.count() == before) {
    problems_.report(where, "a time of " + text + " is no time at all; give a longer one");
  }
  return length;
}

}  // namespace suture
