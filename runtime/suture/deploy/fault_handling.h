#pragma once
// This does what a deployment says about faults of a process: restarts, and the black box.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>
#include <suture/record/black_box.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// Gives tasks their restart budgets. `components` are in the order of `process`, and null where
/// one cannot be created. Adds a problem if a device must be restarted, or the black box has no
/// folder to write to.
void prepareForFaults(const JsonDocument& document, const ProcessEntry& process,
                      std::span<const std::unique_ptr<Component>> components,
                      std::vector<std::string>& problems);

/// One thread uses it. Runs the black box, and has its news and those of restarts.
class FaultHandling {
 public:
  /// `components` are in the order of `process`; both outlive this.
  FaultHandling(const ProcessEntry& process, std::span<const std::unique_ptr<Component>> components)
      : process_(process), components_(components) {}

  /// Call it when the components have their names, before they are started and connected.
  void begin();

  /// Returns what has happened since the last call, a line each: components that run again after a
  /// fault, and files of the black box.
  std::vector<std::string> news();

  /// Ends the black box, which first writes what it still has to; news() has that afterwards.
  void end() { box_.reset(); }

 private:
  struct Known {
    const Component* component;
    std::uint64_t faults = 0;  // those that news() has returned
  };

  std::vector<Component*> watched() const;

  const ProcessEntry& process_;
  const std::span<const std::unique_ptr<Component>> components_;
  std::vector<Known> known_;
  std::mutex mutex_;  // shared by this and the black box's thread
  std::vector<std::string> told_;
  std::optional<BlackBox> box_;  // last: its thread uses the others
};

}  // namespace suture
