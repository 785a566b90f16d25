#pragma once
// What a deployment says about the threads and the memory of a process, as far as the machine
// grants it.

#include <suture/component/component.h>
#include <suture/deploy/deployment.h>
#include <suture/manager/manager.h>
#include <suture/rt/scheduling.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// Used by one thread, before anything of the process runs. What is not granted is a warning, and
/// the process runs without it; or an error, if its file says that real time is required.
class RealTime {
 public:
  /// Locks the memory of this process, present and future, if `process` says so. Both arguments
  /// outlive this.
  RealTime(const JsonDocument& document, const ProcessEntry& process);

  /// `components`: in the order of the process; `manager`: theirs, before it is started. Throws
  /// DocumentError: a component without a thread of its own is to be scheduled, or something is
  /// required that is not granted.
  void giveTo(std::span<const std::unique_ptr<Component>> components, Manager& manager);

  /// Each once, as "file:line: warning: ...".
  std::vector<std::string> news();

 private:
  void lockMemory();
  void schedule(Component& component, const ComponentEntry& entry);
  rt::Scheduling granted(const std::string& whose, const rt::Scheduling& wanted,
                         const std::string& pointer);
  void refuse(const std::string& pointer, const std::string& text);

  const JsonDocument& document_;
  const ProcessEntry& process_;
  std::vector<std::string> problems_, warnings_;
};

}  // namespace suture
