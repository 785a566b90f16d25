#include "tables/comparison.h"

#include <fmt/format.h>

#include <map>

#include "tables/short_names.h"
#include "tables/table.h"

namespace demo {
namespace {

using nlohmann::json;
using suture::Deployment;

/// An Entry is what a deployment says of one thing: where it belongs, and everything else.
struct Entry {
  std::string place;
  json settings;
};
using Entries = std::map<std::string, Entry>;

json without(json entry, std::initializer_list<const char*> keys) {
  for (const char* const key : keys) entry.erase(key);
  return entry;
}

const json& at(const Deployment& deployment, const std::string& pointer) {
  return deployment.document().value().at(json::json_pointer(pointer));
}

Entries processesOf(const Deployment& deployment) {
  Entries entries;
  for (const suture::ProcessEntry& process : deployment.processes()) {
    entries["process " + process.name] = {
        "", without(at(deployment, process.pointer), {"name", "components"})};
  }
  return entries;
}

Entries componentsOf(const Deployment& deployment, const ShortNames& names) {
  Entries entries;
  for (const suture::ProcessEntry& process : deployment.processes()) {
    for (const suture::ComponentEntry& component : process.components) {
      entries[names.of(process.name, component.name)] = {
          process.name, without(at(deployment, component.pointer), {"name"})};
    }
  }
  return entries;
}

Entries connectionsOf(const Deployment& deployment, const ShortNames& names) {
  Entries entries;
  for (const suture::ConnectionEntry& connection : deployment.connections()) {
    entries[names.of(connection.from)] = {
        names.of(connection.to), without(at(deployment, connection.pointer), {"from", "to"})};
  }
  return entries;
}

/// Adds a difference for each value that the two do not share.
void compareSettings(const std::string& subject, const json& first, const json& second,
                     std::vector<Difference>& settings) {
  if (first == second) return;
  json all = first.flatten();
  all.update(second.flatten());
  const auto textIn = [](const json& whole, const std::string& pointer) {
    const json::json_pointer place(pointer);
    return whole.contains(place) ? whole.at(place).dump() : "-";
  };
  for (const auto& [pointer, unused] : all.items()) {
    if (pointer.empty()) continue;  // an entry without settings has nothing to compare
    const Difference one{subject + pointer, textIn(first, pointer), textIn(second, pointer)};
    if (one.first != one.second) settings.push_back(one);
  }
}

/// Returns how many have the same place in both.
std::size_t compareEntries(const Entries& first, const Entries& second,
                           std::vector<Difference>& places, std::vector<Difference>& settings) {
  std::size_t equal = 0;
  Entries all = first;
  all.insert(second.begin(), second.end());
  for (const auto& [name, unused] : all) {
    const auto left = first.find(name), right = second.find(name);
    const Difference place{name, left == first.end() ? "-" : left->second.place,
                           right == second.end() ? "-" : right->second.place};
    if (place.first == place.second) {
      ++equal;
    } else {
      places.push_back(place);
    }
    if (left == first.end() || right == second.end()) continue;
    compareSettings(name, left->second.settings, right->second.settings, settings);
  }
  return equal;
}

std::string tableOf(const std::string& title, const std::string& first, const std::string& second,
                    const std::vector<Difference>& differences) {
  if (differences.empty()) return "";
  Table table({title, first, second});
  for (const Difference& one : differences) table.add({one.subject, one.first, one.second});
  return fmt::format("{}\n\n", fmt::join(table.lines(), "\n"));
}

}  // namespace

Comparison compare(const Deployment& first, const Deployment& second) {
  const ShortNames names({&first, &second});
  Comparison found;
  std::vector<Difference> unused;  // a process that is missing shows in its components
  compareEntries(processesOf(first), processesOf(second), unused, found.settings);
  found.equalPlaces = compareEntries(componentsOf(first, names), componentsOf(second, names),
                                     found.places, found.settings);
  found.equalConnections = compareEntries(connectionsOf(first, names), connectionsOf(second, names),
                                          found.connections, found.settings);
  return found;
}

std::string describe(const Comparison& comparison, const std::string& first,
                     const std::string& second) {
  return tableOf("component runs in process", first, second, comparison.places) +
         tableOf("value", first, second, comparison.settings) +
         tableOf("connection to", first, second, comparison.connections) +
         fmt::format(
             "{} of {} components run in the same process, {} of {} connections lead to the same "
             "provider.\n",
             comparison.equalPlaces, comparison.equalPlaces + comparison.places.size(),
             comparison.equalConnections,
             comparison.equalConnections + comparison.connections.size());
}

}  // namespace demo
