#include "compiler/lock/schema/node_index.h"

#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::lock {

NodeIndex::NodeIndex(const Lock& lock) : lock_(lock) {
  for (const Node& node : lock.nodes) {
    names_.emplace(node.name, &node);
    const std::string name = identity(node);
    identities_.emplace(name, &node);
    if (!node.removed()) living_.emplace(name, &node);
  }
}

const Node* NodeIndex::ofContract(const char* annotation, const std::string& contract) const {
  return identified(annotation + (" " + quoted(contract)));
}

const Node* NodeIndex::find(const Table& table, const std::string& name) {
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

NodeIndexes indexed(const std::map<std::string, Lock>& locks) {
  NodeIndexes indexes;
  for (const auto& [path, lock] : locks) indexes.emplace(path, lock);
  return indexes;
}

}  // namespace suture::compiler::lock
