#pragma once
// These find nodes of locks by their names in about the same time, however many there are.

#include <map>
#include <string>
#include <unordered_map>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Finds the nodes of one lock, which must outlive it and stay unchanged. Each function returns
/// the first node of several, and null if there is none.
class NodeIndex {
 public:
  explicit NodeIndex(const Lock& lock);

  const Lock& lock() const { return lock_; }
  /// Finds by the name on the wire.
  const Node* named(const std::string& name) const { return find(names_, name); }
  /// Finds by what identity() returns.
  const Node* identified(const std::string& identity) const { return find(identities_, identity); }
  /// Finds the same among the nodes that were not removed.
  const Node* living(const std::string& identity) const { return find(living_, identity); }
  /// Finds by the contract that `annotation` names: the node of "cxx" has its commands, that of
  /// "eventsOf" its events, that of "stateOf" its columns.
  const Node* ofContract(const char* annotation, const std::string& contract) const;

 private:
  using Table = std::unordered_map<std::string, const Node*>;

  static const Node* find(const Table& table, const std::string& name);

  const Lock& lock_;
  Table names_;
  Table identities_;
  Table living_;
};

/// Holds the nodes of several locks by the paths of these.
using NodeIndexes = std::map<std::string, NodeIndex>;

NodeIndexes indexed(const std::map<std::string, Lock>& locks);

}  // namespace suture::compiler::lock
