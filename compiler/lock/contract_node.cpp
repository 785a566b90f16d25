#include "compiler/lock/contract_node.h"

#include <algorithm>

#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::lock {

const Node* nodeOf(const Lock& lock, const char* annotation, const std::string& contract) {
  const std::string name = quoted(contract);
  const auto found = std::find_if(lock.nodes.begin(), lock.nodes.end(), [&](const Node& node) {
    return valueOf(node.annotations, annotation) == name;
  });
  return found == lock.nodes.end() ? nullptr : &*found;
}

}  // namespace suture::compiler::lock
