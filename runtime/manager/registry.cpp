#include <suture/base/nearest.h>
#include <suture/manager/registry.h>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

constexpr std::size_t kMaxProcesses = 4096;
constexpr std::size_t kMaxName = 100;

/// A name that cannot be mistaken for part of "process:component/interface", nor for a path.
bool isName(const std::string& name) {
  return !name.empty() && name.size() <= kMaxName &&
         name.find_first_of(":/ \t\n") == std::string::npos;
}

std::string title(const ProcessRecord& process) {
  return "process " + std::to_string(process.pid) + " on " +
         (process.host.empty() ? "this machine" : process.host);
}

}  // namespace

tl::expected<std::uint64_t, Refusal> Registry::add(ProcessRecord process) {
  const std::string asked = "register process '" + process.name + "': ";
  if (!isName(process.name)) {
    return tl::unexpected(Refusal{
        Kind::MALFORMED, asked +
                             "a name has 1 to 100 characters, none of them ':', '/' or a space. "
                             "Choose another name."});
  }
  if (const ProcessRecord* holder = find(process.name)) {
    return tl::unexpected(
        Refusal{Kind::NAME_TAKEN, asked + "the name is held by " + title(*holder) +
                                      ", which is alive. Stop it or choose another name."});
  }
  if (processes_.size() == kMaxProcesses && !processes_.contains(process.name)) {
    return tl::unexpected(Refusal{
        Kind::LIMIT_REACHED, asked + "the manager knows as many processes as it can. Stop some."});
  }
  process.silent = false;
  process.generation = ++generation_;
  const std::string name = process.name;
  processes_.insert_or_assign(name, Entry{std::move(process)});
  return generation_;
}

Registry::Entry* Registry::held(const std::string& name, std::uint64_t generation) {
  const auto found = processes_.find(name);
  const bool held = found != processes_.end() && found->second.process.generation == generation;
  return held ? &found->second : nullptr;
}

void Registry::update(const std::string& name, std::uint64_t generation,
                      std::vector<ComponentRecord> components) {
  Entry* const entry = held(name, generation);
  if (entry != nullptr) entry->process.components = std::move(components);
}

bool Registry::renew(const std::string& name, std::uint64_t generation) {
  Entry* const entry = held(name, generation);
  if (entry == nullptr) return false;
  entry->missed = 0;
  entry->process.silent = false;
  return true;
}

void Registry::age() {
  for (auto& [name, entry] : processes_) {
    if (entry.process.silent) continue;
    entry.process.silent = ++entry.missed > wire::MISSABLE_RENEWALS;
  }
}

void Registry::remove(const std::string& name, std::uint64_t generation) {
  if (held(name, generation) != nullptr) processes_.erase(name);
}

const ProcessRecord* Registry::find(const std::string& name) const {
  const auto found = processes_.find(name);
  if (found == processes_.end() || found->second.process.silent) return nullptr;
  return &found->second.process;
}

std::vector<ProcessRecord> Registry::list() const {
  std::vector<ProcessRecord> all;
  for (const auto& [name, entry] : processes_) all.push_back(entry.process);
  return all;
}

Refusal Registry::unknown(const std::string& name, std::uint32_t waitedMilliseconds) const {
  const auto silent = processes_.find(name);
  if (silent != processes_.end()) {
    return {Kind::NO_SUCH_PROCESS, "find process '" + name + "': " + title(silent->second.process) +
                                       " has been silent for longer than its lease. Look at what "
                                       "it is doing, or start another of that name."};
  }
  std::vector<std::string> names;
  for (const auto& [known, entry] : processes_) names.push_back(known);
  const std::string nearest = nearestName(name, names);
  std::string text = "find process '" + name + "': the manager knows " + listNames(names);
  if (waitedMilliseconds != 0) {
    text += ", and has waited " + std::to_string(waitedMilliseconds) + " ms";
  }
  text += nearest.empty() ? ". Start that process, with this manager's address."
                          : ". Did you mean '" + nearest + "'?";
  return {Kind::NO_SUCH_PROCESS, text};
}

}  // namespace suture
