#pragma once
// These are the components that one process of a deployment has to run.

#include <suture/component/component.h>
#include <suture/component/factory/component_class.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/process/collectors.h>
#include <suture/deploy/process/shared_library.h>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// One thread uses it. Creates components, and gives them what the file says of their frames,
/// restarts and scheduling; starts and connects nothing.
class ProcessComponents {
 public:
  /// Creates the components of `process` from `classes` and from the libraries that it names. All
  /// arguments outlive this. Adds a problem for a library that cannot be loaded, an unknown class,
  /// wrong or refused parameters, a connection that names an interface which its component does not
  /// have, a required interface without one, and frames, a restart, a black box or a scheduling
  /// that cannot be.
  ProcessComponents(const Deployment& deployment, const ProcessEntry& process,
                    std::span<const ComponentClass> classes, std::vector<std::string>& problems);

  /// Returns them in the order of the file, null where one cannot be created.
  std::span<const std::unique_ptr<Component>> all() const { return components_; }

 private:
  void create(std::vector<std::string>& problems);
  std::unique_ptr<Component> create(const ComponentEntry& entry, const Collectors::Create& create,
                                    std::vector<std::string>& problems);
  Collectors::Create creatorOf(const ComponentEntry& entry, std::vector<std::string>& problems);
  std::set<std::string> toldByCollectors() const;
  const SharedLibrary& library(const std::filesystem::path& file);

  const Deployment& deployment_;
  const ProcessEntry& process_;
  const std::span<const ComponentClass> ofProgram_;
  std::map<std::filesystem::path, SharedLibrary> libraries_;  // outlive what they contain
  Collectors collectors_{deployment_, process_};
  std::vector<std::unique_ptr<Component>> components_;
};

}  // namespace suture
