#include "compiler/lock/major_versions.h"

#include <algorithm>
#include <cstdlib>

#include "compiler/lock/schema/reach.h"

namespace suture::compiler::lock {

unsigned majorOf(const Node& node) {
  const auto major = node.annotations.find("major");
  if (major == node.annotations.end()) return 1;
  return static_cast<unsigned>(std::strtoul(major->second.c_str(), nullptr, 10));
}

unsigned majorOf(const NodeIndexes& locks, const std::string& contract) {
  for (const auto& [path, lock] : locks) {
    if (const Node* const node = lock.ofContract("cxx", contract)) return majorOf(*node);
  }
  return 1;
}

void raiseMajors(std::map<std::string, Lock>& locks, const std::set<std::string>& own,
                 const std::set<std::string>& broken) {
  for (const std::string& path : own) {
    for (Node& node : locks.at(path).nodes) {
      if (node.kind != Node::Kind::Interface || !node.annotations.contains("cxx")) continue;
      const std::set<std::string> reached = reach(locks, path, node.name);
      const bool affected = std::any_of(broken.begin(), broken.end(), [&](const std::string& one) {
        return reached.contains(one);
      });
      if (affected) node.annotations["major"] = std::to_string(majorOf(node) + 1);
    }
  }
}

}  // namespace suture::compiler::lock
