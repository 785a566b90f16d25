#include <suture/base/nearest.h>
#include <suture/names/registry.h>

#include <algorithm>
#include <cctype>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

constexpr std::size_t kMaxName = 100;

std::string inBytes(std::size_t count) { return std::to_string(count) + " bytes"; }

std::string title(const ProcessRecord& process) {
  return "process " + std::to_string(process.pid) + " on " +
         (process.host.empty() ? "this machine" : process.host);
}

}  // namespace

// A name with one of these could be mistaken for part of "process:component/interface", or for a
// path.
std::string whyNoName(const std::string& name) {
  const bool good = !name.empty() && name.size() <= kMaxName &&
                    std::none_of(name.begin(), name.end(), [](unsigned char one) {
                      return one == ':' || one == '/' || one == ' ' || std::iscntrl(one) != 0;
                    });
  if (good) return "";
  return "register process '" + name +
         "': a name has 1 to 100 characters, none of them ':', '/', a space or a control "
         "character. Choose another name.";
}

tl::expected<std::uint64_t, Refusal> Registry::add(ProcessRecord process,
                                                   std::shared_ptr<Holding> holding) {
  const std::size_t bytes = bytesOf(process);
  if (const auto refusal = whyNot(process, bytes, *holding)) return tl::unexpected(*refusal);
  if (const auto silent = processes_.find(process.name); silent != processes_.end()) erase(silent);
  process.silent = false;
  process.generation = ++generation_;
  count(*holding, 1, static_cast<std::ptrdiff_t>(bytes));
  const std::string name = process.name;
  processes_.emplace(name, Entry{std::move(process), bytes, std::move(holding)});
  return generation_;
}

std::optional<Refusal> Registry::whyNot(const ProcessRecord& process, std::size_t bytes,
                                        const Holding& holding) const {
  const std::string asked = "register process '" + process.name + "': ";
  if (const std::string why = whyNoName(process.name); !why.empty()) {
    return Refusal{Kind::MALFORMED, why};
  }
  if (const ProcessRecord* holder = find(process.name)) {
    return Refusal{Kind::NAME_TAKEN, asked + "the name is held by " + title(*holder) +
                                         ", which is alive. Stop it or choose another name."};
  }
  const std::string why = whyTooMuch(process.name, bytes, holding);
  if (why.empty()) return std::nullopt;
  return Refusal{Kind::LIMIT_REACHED, asked + why};
}

std::string Registry::whyTooMuch(const std::string& name, std::size_t asked,
                                 const Holding& holding) const {
  const auto replaced = processes_.find(name);
  const bool isNew = replaced == processes_.end();
  const bool isNewOfLink = isNew || replaced->second.holding.get() != &holding;
  const std::size_t before = isNew ? 0 : replaced->second.bytes;
  if (asked > kMostBytesOfARecord) {
    return "its components and interfaces take " + inBytes(asked) +
           ", and no process is given more than " + inBytes(kMostBytesOfARecord) +
           ". Divide it into several.";
  }
  if (isNew && processes_.size() == kMostNames) {
    return "the manager knows " + std::to_string(kMostNames) +
           " processes, and knows no more. Stop those that are not needed.";
  }
  if (isNewOfLink && holding.names == kMostNamesOfALink) {
    return "its link holds " + std::to_string(kMostNamesOfALink) +
           " names, and none holds more. Use another.";
  }
  if (holding.bytes - (isNewOfLink ? 0 : before) + asked > kMostBytesOfALink) {
    return "the processes of its link would take more than " + inBytes(kMostBytesOfALink) +
           ". Use another link.";
  }
  if (const Holding* const peer = holding.peer.get()) {
    const bool isNewOfPeer = isNew || replaced->second.holding->peer.get() != peer;
    if (isNewOfPeer && peer->names == kMostNamesOfAPeer) {
      return "the processes of its user, or with its certificate, are " +
             std::to_string(kMostNamesOfAPeer) +
             ", and the manager knows no more of one. Stop some.";
    }
    if (peer->bytes - (isNewOfPeer ? 0 : before) + asked > kMostBytesOfAPeer) {
      return "the processes of its user, or with its certificate, would take more than " +
             inBytes(kMostBytesOfAPeer) + ". Stop some.";
    }
  }
  if (bytes_ - before + asked > kMostBytes) {
    return "all processes would take more than " + inBytes(kMostBytes) + ". Stop some.";
  }
  return "";
}

void Registry::erase(Processes::iterator entry) {
  count(*entry->second.holding, -1, -static_cast<std::ptrdiff_t>(entry->second.bytes));
  processes_.erase(entry);
}

void Registry::count(Holding& link, std::ptrdiff_t names, std::ptrdiff_t bytes) {
  bytes_ += bytes;
  for (Holding* one = &link; one != nullptr; one = one->peer.get()) {
    one->names += names;
    one->bytes += bytes;
  }
}

Registry::Entry* Registry::held(const std::string& name, std::uint64_t generation) {
  const auto found = processes_.find(name);
  const bool held = found != processes_.end() && found->second.process.generation == generation;
  return held ? &found->second : nullptr;
}

tl::expected<void, Refusal> Registry::update(const std::string& name, std::uint64_t generation,
                                             std::vector<ComponentRecord> components) {
  Entry* const entry = held(name, generation);
  if (entry == nullptr) return {};
  const std::size_t before = entry->bytes;
  const std::size_t bytes = before - bytesOf(entry->process.components) + bytesOf(components);
  if (const std::string why = whyTooMuch(name, bytes, *entry->holding); !why.empty()) {
    return tl::unexpected(
        Refusal{Kind::LIMIT_REACHED, "replace the components of process '" + name + "': " + why});
  }
  entry->process.components = std::move(components);
  entry->bytes = bytes;
  count(*entry->holding, 0,
        static_cast<std::ptrdiff_t>(bytes) - static_cast<std::ptrdiff_t>(before));
  return {};
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
  if (held(name, generation) != nullptr) erase(processes_.find(name));
}

std::optional<Refusal> Registry::whyTooLong(const std::string& name) {
  if (name.size() <= kMaxName) return std::nullopt;
  return Refusal{Kind::MALFORMED, "find a process by a name of " + inBytes(name.size()) +
                                      ": a name has 1 to 100 characters. Choose another name."};
}

const ProcessRecord* Registry::find(const std::string& name) const {
  const auto found = processes_.find(name);
  if (found == processes_.end() || found->second.process.silent) return nullptr;
  return &found->second.process;
}

Registry::Page Registry::list(const std::string& after, std::size_t bytes) const {
  Page page;
  std::size_t taken = 0;
  for (auto one = processes_.upper_bound(after); one != processes_.end(); ++one) {
    taken += one->second.bytes;
    page.more = !page.processes.empty() && taken > bytes;
    if (page.more) break;
    page.processes.push_back(one->second.process);
  }
  return page;
}

Refusal Registry::unknown(const std::string& name, std::uint32_t waitedMilliseconds) const {
  const auto silent = processes_.find(name);
  if (silent != processes_.end()) {
    return {Kind::NO_SUCH_PROCESS, "find process '" + name + "': " + title(silent->second.process) +
                                       " has not renewed its name in time. See what it does, or "
                                       "start another of that name."};
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
