#pragma once
// What a deployment says about faults of a process: restarts, and the black box.

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

/// Gives tasks their restart budgets, runs the black box, and knows the news of both. Used by one
/// thread.
class FaultHandling {
 public:
  /// `components`: in the order of `process`; both outlive this, and the document. Throws
  /// DocumentError: a device is to be restarted, or the black box has no folder to write to.
  FaultHandling(const JsonDocument& document, const ProcessEntry& process,
                std::span<const std::unique_ptr<Component>> components);

  /// Once the components have their names, before they are started and connected.
  void begin();

  /// What has happened since the last call, a line each: components that run again after a fault,
  /// and files of the black box.
  std::vector<std::string> news();

 private:
  struct Known {
    const Component* component;
    std::uint64_t faults = 0;  // as far as they have been told
  };

  void giveBudgets(std::vector<std::string>& problems) const;
  void checkFolder(std::vector<std::string>& problems) const;
  std::vector<Component*> watched() const;

  const JsonDocument& document_;
  const ProcessEntry& process_;
  const std::span<const std::unique_ptr<Component>> components_;
  std::vector<Known> known_;
  std::mutex mutex_;  // of this and the black box's thread
  std::vector<std::string> told_;
  std::optional<BlackBox> box_;  // last: its thread uses the others
};

}  // namespace suture
