#include "compiler/lock/moves/nodes.h"

#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {

const Node* nodeWithId(const Lock& lock, std::uint64_t id) {
  for (const Node& node : lock.nodes) {
    if (node.id == id) return &node;
  }
  return nullptr;
}

const Node* nodeNamed(const Lock& lock, const std::string& name) {
  for (const Node& node : lock.nodes) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

const Lock* lockAt(const Locks& locks, const std::string& path) {
  for (const auto* const all : {&locks.files, &locks.others}) {
    if (const auto found = all->find(path); found != all->end()) return &found->second;
  }
  return nullptr;
}

bool isDeclared(const Node& node) { return identity(node) != node.name; }

const Node* nodeAt(const Locks& locks, const TypePlace& place) {
  const Lock* const lock = lockAt(locks, place.path);
  return lock == nullptr ? nullptr : nodeNamed(*lock, place.name);
}

}  // namespace suture::compiler::lock
