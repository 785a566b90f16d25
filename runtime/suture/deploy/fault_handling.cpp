#include <suture/component/task/task.h>
#include <suture/deploy/fault_handling.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <utility>

namespace suture {
namespace {

// Makes the files of one run distinct from those of the next: "robot.20260314T150926Z.4711."
std::string prefixOf(const std::string& process) {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc);
  return process + "." + text.data() + "." + std::to_string(getpid()) + ".";
}

void giveBudgets(const JsonDocument& document, const ProcessEntry& process,
                 std::span<const std::unique_ptr<Component>> components,
                 std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < components.size(); ++i) {
    const ComponentEntry& entry = process.components[i];
    if (!entry.restart || components[i] == nullptr) continue;
    if (components[i]->ownsThread()) {
      static_cast<Task&>(*components[i]).restartAfterFaults(*entry.restart);
    } else {
      problems.push_back(document.locate(
          entry.pointer + "/restart",
          "component '" + entry.name + "' of class '" + entry.className +
              "' is to be restarted after faults, but it is a device, which has no thread to be "
              "restarted in; remove 'restart', or make its class a task"));
    }
  }
}

// Looks now, because at the first fault it would be too late to say so.
void checkFolder(const JsonDocument& document, const ProcessEntry& process,
                 std::vector<std::string>& problems) {
  const std::filesystem::path& folder = process.blackBox->folder;
  const bool there = std::filesystem::is_directory(folder);
  if (there && access(folder.c_str(), W_OK | X_OK) == 0) return;
  problems.push_back(document.locate(
      process.blackBox->pointer + "/folder",
      "the black box of process '" + process.name + "' is to write to '" + folder.string() +
          (there ? "', where this user may not write; give it the right to, or name another folder"
                 : "', which is no folder; create it, or name another one")));
}

}  // namespace

void prepareForFaults(const JsonDocument& document, const ProcessEntry& process,
                      std::span<const std::unique_ptr<Component>> components,
                      std::vector<std::string>& problems) {
  giveBudgets(document, process, components, problems);
  if (process.blackBox) checkFolder(document, process, problems);
}

std::vector<Component*> FaultHandling::watched() const {
  const std::vector<std::string>& names = process_.blackBox->components;
  std::vector<Component*> components;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const bool named =
        std::find(names.begin(), names.end(), process_.components[i].name) != names.end();
    if (names.empty() || named) components.push_back(components_[i].get());
  }
  return components;
}

void FaultHandling::begin() {
  for (const auto& component : components_) known_.push_back({component.get()});
  if (!process_.blackBox) return;
  const BlackBoxEntry& entry = *process_.blackBox;
  const BlackBoxOptions options{.folder = entry.folder,
                                .prefix = prefixOf(process_.name),
                                .last = entry.last,
                                .period = entry.period,
                                .rows = entry.rows,
                                .tell = [this](const std::string& text) {
                                  const std::lock_guard lock(mutex_);
                                  told_.push_back("black box: " + text);
                                }};
  box_.emplace(watched(), options);
}

std::vector<std::string> FaultHandling::news() {
  std::vector<std::string> lines;
  for (Known& known : known_) {
    const std::uint64_t faults = known.component->faults();
    const bool running = known.component->state() == ComponentState::Running;
    if (!running || faults == known.faults) continue;
    known.faults = faults;
    lines.push_back("component '" + process_.name + ":" + known.component->name() +
                    "' runs again after fault " + std::to_string(faults) + ": " +
                    known.component->whyFaulted());
  }
  const std::lock_guard lock(mutex_);
  for (std::string& line : std::exchange(told_, {})) lines.push_back(std::move(line));
  return lines;
}

}  // namespace suture
