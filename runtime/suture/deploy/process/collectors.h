#pragma once
// Every deployment has these component classes: "StateCollector" and "EventCollector".

#include <suture/component/component.h>
#include <suture/component/contract/interface_info.h>
#include <suture/deploy/document/deployment.h>
#include <suture/record/json_lines.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Makes the collectors of one process. A collector has the contract of the interface that its
/// "Source" is connected to, so what it collects has to exist before it, in the same process:
/// docs/collecting.md.
class Collectors {
 public:
  using Create = std::function<std::unique_ptr<Component>(const JsonReader& parameters)>;

  /// Both outlive this.
  Collectors(const Deployment& deployment, const ProcessEntry& process)
      : deployment_(deployment), process_(process) {}

  /// Every deployment has these classes, whatever its program.
  static constexpr std::array<const char*, 2> kClasses{"StateCollector", "EventCollector"};
  static bool offers(std::string_view className);
  /// Adds a problem for each collector that writes to a file of another process's collector, or to
  /// the deployment itself.
  static void checkFiles(const Deployment& deployment,
                         const std::function<bool(const ComponentEntry&)>& isCollector,
                         std::vector<std::string>& problems);

  /// Returns what creates the collector `entry`. `components` are in the order of the process, and
  /// null where one does not exist yet. If there is nothing to collect, adds a problem and returns
  /// an empty function.
  Create find(const ComponentEntry& entry, std::span<const std::unique_ptr<Component>> components,
              std::vector<std::string>& problems);

 private:
  const InterfaceInfo* contractOf(const ComponentEntry& entry,
                                  std::span<const std::unique_ptr<Component>> components,
                                  std::vector<std::string>& problems) const;
  std::unique_ptr<Component> create(const std::string& className, const InterfaceInfo& contract,
                                    const JsonReader& parameters);
  std::shared_ptr<Sink> sink(const std::string& file);

  const Deployment& deployment_;
  const ProcessEntry& process_;
  std::map<std::filesystem::path, std::shared_ptr<Sink>> files_;  // by place; several may share one
};

}  // namespace suture
