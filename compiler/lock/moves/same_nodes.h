#pragma once
// This finds what stands in one version of a lock in another version.

#include <cstdint>
#include <map>
#include <string>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {

/// Finds the same node in another lock: first by its id, which outlives renames, then by its name,
/// then by its C++ name. The lock outlives this object.
class SameNodes {
 public:
  explicit SameNodes(const Lock& lock) {
    for (const Node& node : lock.nodes) {
      names_.emplace(node.name, &node);
      identities_.emplace(identity(node), &node);
      ids_.emplace(node.id, &node);
    }
  }

  /// Returns null if there is none.
  const Node* find(const Node& node) const {
    const auto named = names_.find(node.name);
    const bool isNamed = named != names_.end();
    if (isNamed && named->second->id == node.id)
      return named->second;  // the name decides if two nodes have one id
    if (const auto known = ids_.find(node.id); known != ids_.end()) return known->second;
    if (isNamed) return named->second;
    const auto same = identities_.find(identity(node));
    return same == identities_.end() ? nullptr : same->second;
  }

 private:
  std::map<std::string, const Node*> names_, identities_;
  std::map<std::uint64_t, const Node*> ids_;
};

}  // namespace suture::compiler::lock
