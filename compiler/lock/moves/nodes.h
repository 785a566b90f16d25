#pragma once
// These find nodes of locks, and the types that nodes name.

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {

/// Each returns null if there is none.
const Node* nodeWithId(const Lock& lock, std::uint64_t id);
const Node* nodeNamed(const Lock& lock, const std::string& name);
const Lock* lockAt(const Locks& locks, const std::string& path);
const Node* nodeAt(const Locks& locks, const TypePlace& place);

/// Tells if the node stands for a declaration, and is no composite.
bool isDeclared(const Node& node);

/// Calls visit(type) for each type that the member names.
template <class OneMember, class Visit>
void forEachType(OneMember& member, const Visit& visit) {
  visit(member.type);
  for (auto& parameter : member.parameters) forEachType(parameter, visit);
  for (auto& result : member.results) forEachType(result, visit);
}

template <class OneNode, class Visit>
void forEachType(OneNode& node, std::vector<std::string>& bases, const Visit& visit) {
  for (std::string& base : bases) visit(base);
  for (auto& member : node.members) forEachType(member, visit);
}

}  // namespace suture::compiler::lock
