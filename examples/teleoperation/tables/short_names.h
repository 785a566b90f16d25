#pragma once
// These are the names of components on the screen.

#include <suture/deploy/document/deployment.h>

#include <string>
#include <vector>

namespace demo {

/// Returns only a component's name, if no two of a deployment have the same; else its process too.
/// So equal connections have equal names in every topology.
class ShortNames {
 public:
  /// The names serve several deployments that are looked at together.
  explicit ShortNames(const std::vector<const suture::Deployment*>& deployments);

  std::string of(const std::string& process, const std::string& component) const;
  std::string of(const suture::Endpoint& endpoint) const;
  /// Returns who requires which interface, and of whom: "TeleopL/Slave -> PSM1".
  std::string of(const suture::ConnectionEntry& connection) const;

 private:
  bool unique_ = true;
};

}  // namespace demo
