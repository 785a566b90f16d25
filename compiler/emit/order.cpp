#include "compiler/emit/order.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/lock/wire_type.h"

namespace suture::compiler::emit {
namespace {

const lock::Node* findNode(const lock::Lock& lock, const char* annotation,
                           const std::string& interface) {
  for (const lock::Node& node : lock.nodes) {
    const auto found = node.annotations.find(annotation);
    if (found != node.annotations.end() && found->second == lock::quoted(interface)) return &node;
  }
  return nullptr;
}

unsigned ordinalOf(const lock::Node& node, const std::string& name) {
  for (const lock::Member& member : node.members) {
    if (member.name == name && !member.removed()) return member.ordinal;
  }
  return std::numeric_limits<unsigned>::max();
}

template <class Declarations>
void sort(Declarations& declarations, const lock::Node* node) {
  if (node == nullptr) return;
  std::stable_sort(declarations.begin(), declarations.end(), [&](const auto& a, const auto& b) {
    return ordinalOf(*node, a.wireName) < ordinalOf(*node, b.wireName);
  });
}

/// Puts structs behind those that they hold, and else leaves their order.
class PartsFirst {
 public:
  explicit PartsFirst(std::vector<model::Struct>& structs) : structs_(structs) {}

  void sort() {
    for (const model::Struct& record : structs_) place(record.name);
    structs_ = std::move(sorted_);
  }

 private:
  void place(const std::string& name) {
    const auto found = std::find_if(structs_.begin(), structs_.end(),
                                    [&](const model::Struct& one) { return one.name == name; });
    if (found == structs_.end() || !seen_.insert(name).second) return;
    for (const model::Field& field : found->fields) place(field.type);
    sorted_.push_back(*found);
  }

  void place(const model::Type& type) {
    if (!type.name.empty()) place(type.name);
    for (const model::Type& element : type.element) place(element);
  }

  std::vector<model::Struct>& structs_;
  std::vector<model::Struct> sorted_;
  std::set<std::string> seen_;
};

}  // namespace

model::Model ordered(model::Model model, const lock::Locks& locks) {
  for (model::Header& header : model.headers) {
    PartsFirst(header.structs).sort();
    const auto lock = locks.files.find(lock::lockPath(header.path));
    if (lock == locks.files.end()) continue;
    for (model::Interface& interface : header.interfaces) {
      sort(interface.commands, findNode(lock->second, "cxx", interface.name));
      sort(interface.events, findNode(lock->second, "eventsOf", interface.name));
    }
  }
  return model;
}

}  // namespace suture::compiler::emit
