#pragma once
// This collects a contract as it is on the wire: what its lock says of it and of all that it leads
// to.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/node_index.h"

namespace suture::compiler::lock {

/// A PlacedNode is a node and the file that it stands in.
struct PlacedNode {
  const Lock* lock = nullptr;
  const Node* node = nullptr;
};

/// Returns the locks as an update would leave them, by path, also if a header is ahead of its lock.
std::map<std::string, Lock> upToDate(const model::Model& model, const Locks& locks);

class WireContract {
 public:
  /// `locks` must outlive this. `withoutOptional` leaves the optional commands out.
  WireContract(const NodeIndexes& locks, bool withoutOptional)
      : locks_(locks), withoutOptional_(withoutOptional) {}

  /// Adds the node that `type`, as `lock` spells it, names, and then all that it leads to, each
  /// once.
  void add(const Lock& lock, const std::string& type);
  const std::vector<PlacedNode>& nodes() const { return nodes_; }

  /// Tells if the member travels: it was not removed, nor left out as optional.
  bool counts(const Member& member) const {
    return !member.removed() && !(withoutOptional_ && member.annotations.contains("optional"));
  }

  /// Returns the node of a type spelled in `lock`; of lists, that of the innermost element. The
  /// result is empty if the type is one of capnp or of Suture.
  PlacedNode find(const Lock& lock, const std::string& type) const;

 private:
  void add(const Lock& lock, const Member& member);

  const NodeIndexes& locks_;
  const bool withoutOptional_;
  std::vector<PlacedNode> nodes_;
  std::set<const Node*> known_;
};

}  // namespace suture::compiler::lock
