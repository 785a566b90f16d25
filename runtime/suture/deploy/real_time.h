#pragma once
// This gives a process what its deployment says about threads and memory, as far as the machine
// grants it.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>
#include <suture/manager/manager.h>
#include <suture/rt/scheduling.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// Gives each of `components`, which are in the order of `process` and null where one cannot be
/// created, the scheduling that the file wants. Adds a problem for one without its own thread.
void giveScheduling(const JsonDocument& document, const ProcessEntry& process,
                    std::span<const std::unique_ptr<Component>> components,
                    std::vector<std::string>& problems);

/// One thread uses it, before anything of the process runs. What is not granted is a warning, and
/// the process runs without it, or an error, if its file says that real time is required.
class RealTime {
 public:
  /// Asks the machine for what `process` says, and locks the memory of this process, present and
  /// future, if it says so. Both arguments outlive this. Throws DocumentError if something is
  /// required that is not granted.
  RealTime(const JsonDocument& document, const ProcessEntry& process);

  /// Leaves the components what is granted of what giveScheduling() gave them. `components` are in
  /// the order of the process, and giveScheduling() has found no problem of them.
  void giveTo(std::span<const std::unique_ptr<Component>> components) const;
  /// Call it before the manager is started.
  void giveTo(Manager& manager) const;

  /// Returns each warning once, as "file:line: warning: ...".
  std::vector<std::string> news();

 private:
  using Wish = std::optional<rt::Scheduling>;

  void lockMemory();
  Wish granted(const std::string& whose, const Wish& wanted, const std::string& pointer);
  void refuse(const std::string& pointer, const std::string& text);

  const JsonDocument& document_;
  const ProcessEntry& process_;
  std::vector<std::string> problems_, warnings_;
  std::vector<Wish> components_;  // what each has; in the order of the process
  Wish service_;
};

}  // namespace suture
