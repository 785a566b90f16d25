#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/component/factory/json_reader.h>
#include <suture/component/provided.h>
#include <suture/deploy/process/collectors.h>
#include <suture/manager/lifecycle_interface.h>
#include <suture/record/event_collector.h>
#include <suture/record/state_collector.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <system_error>

namespace suture {
namespace {

constexpr std::string_view kStates = Collectors::kClasses[0];

constexpr double kLongestInterval = 86400;  // s

/// Holds what a deployment says of a collector.
struct Parameters {
  std::string file;
  std::vector<std::string> names;  // the reads or the events that are collected
  CollectingInterval interval;
  Duration period = StateCollectorOptions{}.period;
  bool collecting = true;
};

Parameters parametersFrom(const JsonReader& in, bool states) {
  Parameters values;
  JsonReader reader = in;
  reader.field("file", values.file);
  reader.field(states ? "reads" : "events", values.names);
  reader.field("every", values.interval.every, 1, std::numeric_limits<std::uint32_t>::max());
  reader.field("at_least", values.interval.atLeast, 0, kLongestInterval);
  reader.field("collecting", values.collecting);
  if (states) reader.field("period", values.period, 0.0001, kLongestInterval);
  reader.finish();
  if (values.file.empty()) {
    reader.report(
        "key 'file' is missing; it is the file to write to, from the deployment's folder");
  }
  return values;
}

/// Returns what two spellings of one path have in common. A path without a place in the file
/// system, as that of a pipe, stays as it is.
std::filesystem::path placeOf(const std::filesystem::path& file) {
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(file, failed);
  std::filesystem::path place = std::filesystem::weakly_canonical(whole, failed);
  return failed ? file.lexically_normal() : place;
}

/// Returns what `component` provides as `name`, or what its manager will provide for it.
const InterfaceInfo* provided(const Component& component, std::string_view name) {
  for (const ProvidedBase* one : component.provided()) {
    if (one->name() == name) return &one->info();
  }
  return name == LifecycleInterface::kName ? &interfaceInfo<Lifecycle>() : nullptr;
}

std::string noSuchInterface(const Component& component, const Endpoint& asked) {
  std::vector<std::string> names{LifecycleInterface::kName};
  for (const ProvidedBase* one : component.provided()) names.push_back(one->name());
  const std::string nearest = nearestName(asked.interface, names);
  return "component '" + asked.component + "' has no provided interface '" + asked.interface +
         "'; it has " + listNames(names) +
         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

}  // namespace

bool Collectors::offers(std::string_view className) {
  return std::find(kClasses.begin(), kClasses.end(), className) != kClasses.end();
}

void Collectors::checkFiles(const Deployment& deployment,
                            const std::function<bool(const ComponentEntry&)>& isCollector,
                            std::vector<std::string>& problems) {
  struct Use {
    const ProcessEntry* process;
    std::string pointer;
  };
  std::map<std::filesystem::path, Use> first;
  for (const ProcessEntry& process : deployment.processes()) {
    for (const ComponentEntry& entry : process.components) {
      const auto file = entry.parameters.find("file");
      if (!isCollector(entry) || file == entry.parameters.end() || !file->is_string()) continue;
      const std::string pointer = entry.pointer + "/parameters/file";
      const std::string& name = file->get_ref<const std::string&>();
      const std::filesystem::path place = placeOf(deployment.document().besideIt(name));
      if (place == placeOf(deployment.document().name())) {
        problems.push_back(deployment.document().locate(
            pointer, "'" + name +
                         "' is this deployment file itself, which a recording would replace; "
                         "name another file"));
        continue;
      }
      const auto [other, added] = first.emplace(place, Use{&process, pointer});
      if (added || other->second.process == &process) continue;
      problems.push_back(deployment.document().locate(
          pointer, "'" + name + "' is written by process '" + other->second.process->name +
                       "' already, on line " +
                       std::to_string(deployment.document().lineOf(other->second.pointer)) +
                       "; only collectors of one process may share a file: name another one"));
    }
  }
}

Collectors::Create Collectors::find(const ComponentEntry& entry,
                                    std::span<const std::unique_ptr<Component>> components,
                                    std::vector<std::string>& problems) {
  const InterfaceInfo* const contract = contractOf(entry, components, problems);
  if (contract == nullptr) return {};
  return [this, &className = entry.className, contract](const JsonReader& parameters) {
    return create(className, *contract, parameters);
  };
}

const InterfaceInfo* Collectors::contractOf(const ComponentEntry& entry,
                                            std::span<const std::unique_ptr<Component>> components,
                                            std::vector<std::string>& problems) const {
  const auto refuse = [&](const std::string& pointer, const std::string& text) {
    problems.push_back(deployment_.document().locate(pointer, text));
    return nullptr;
  };
  const std::string source = Endpoint{process_.name, entry.name, "Source"}.toString();
  const auto& all = deployment_.connections();
  const auto connection = std::find_if(all.begin(), all.end(), [&](const ConnectionEntry& one) {
    return one.from.toString() == source;
  });
  if (connection == all.end()) {
    return refuse(entry.pointer, "collector '" + entry.name +
                                     "' has nothing to collect; add a connection {\"from\": \"" +
                                     source + "\", \"to\": ...}");
  }
  const Endpoint& to = connection->to;
  if (to.process != process_.name) {
    return refuse(connection->pointer + "/to",
                  "collector '" + entry.name + "' is to collect '" + to.toString() +
                      "' of another process; put it into process '" + to.process +
                      "', where nothing is lost on the way to it");
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (process_.components[i].name != to.component) continue;
    if (components[i] == nullptr && !offers(process_.components[i].className)) return nullptr;
    if (components[i] == nullptr) {
      return refuse(connection->pointer + "/to",
                    "collector '" + entry.name + "' is to collect another collector, '" +
                        to.component + "'; connect it to what that one collects");
    }
    const InterfaceInfo* const contract = provided(*components[i], to.interface);
    if (contract != nullptr) return contract;
    return refuse(connection->pointer + "/to", noSuchInterface(*components[i], to));
  }
  return nullptr;  // the deployment has checked that there is such a component
}

std::unique_ptr<Component> Collectors::create(const std::string& className,
                                              const InterfaceInfo& contract,
                                              const JsonReader& parameters) {
  const bool states = className == kStates;
  const Parameters values = parametersFrom(parameters, states);
  if (parameters.failed()) return nullptr;
  if (states) {
    const StateCollectorOptions options{.reads = values.names,
                                        .interval = values.interval,
                                        .period = values.period,
                                        .collecting = values.collecting};
    return std::make_unique<StateCollector>(contract, options, sink(values.file));
  }
  const EventCollectorOptions options{
      .events = values.names, .interval = values.interval, .collecting = values.collecting};
  return std::make_unique<EventCollector>(contract, options, sink(values.file));
}

std::shared_ptr<Sink> Collectors::sink(const std::string& file) {
  const std::filesystem::path path = deployment_.document().besideIt(file);
  std::shared_ptr<Sink>& known = files_[placeOf(path)];
  if (known == nullptr) known = std::make_shared<JsonLines>(path);
  return known;
}

}  // namespace suture
