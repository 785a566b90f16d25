#include "compiler/emit/text/order.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/emit/text/context.h"
#include "compiler/lock/schema/node_index.h"
#include "compiler/model/lookup.h"

namespace suture::compiler::emit {
namespace {

constexpr unsigned kUnknown = std::numeric_limits<unsigned>::max();

using Ordinals = std::unordered_map<std::string, unsigned>;

Ordinals ordinalsOf(const lock::Node* node) {
  Ordinals ordinals;
  if (node == nullptr) return ordinals;
  for (const lock::Member& member : node->members) {
    if (!member.removed()) ordinals.emplace(member.name, member.ordinal);
  }
  return ordinals;
}

/// Says where a command or event stands: what a base declares comes first, in the base's own order.
struct Place {
  std::size_t depth;
  unsigned ordinal;

  auto operator<=>(const Place&) const = default;
};

/// Returns the contracts that `interface` derives from, outermost first, and itself.
std::vector<const model::Interface*> lineage(const model::Interface& interface,
                                             const model::Lookup& lookup) {
  std::vector<const model::Interface*> line;
  for (const model::Interface* one = &interface; one != nullptr;
       one = lookup.findInterface(one->base)) {
    line.insert(line.begin(), one);
  }
  return line;
}

class Order {
 public:
  Order(const model::Lookup& lookup, const lock::Locks& locks)
      : lookup_(lookup), locks_(lock::indexed(locks.files)) {}

  void sort(model::Interface& interface) const {
    sort(interface, interface.commands, "cxx");
    sort(interface, interface.events, "eventsOf");
  }

 private:
  template <class Declarations>
  void sort(const model::Interface& interface, Declarations& declarations,
            const char* annotation) const {
    const auto line = lineage(interface, lookup_);
    std::vector<Ordinals> ordinals;
    for (const auto* const one : line) ordinals.push_back(ordinalsOf(nodeOf(*one, annotation)));
    const auto place = [&](const auto& one) {
      const std::string& home = one.inheritedFrom.empty() ? interface.name : one.inheritedFrom;
      std::size_t depth = 0;
      while (depth + 1 < line.size() && line[depth]->name != home) ++depth;
      const auto known = ordinals[depth].find(one.wireName);
      return Place{depth, known == ordinals[depth].end() ? kUnknown : known->second};
    };
    std::stable_sort(declarations.begin(), declarations.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
    for (auto& one : declarations) {
      const unsigned ordinal = place(one).ordinal;
      if (ordinal != kUnknown) one.ordinal = ordinal;
    }
  }

  const lock::Node* nodeOf(const model::Interface& interface, const char* annotation) const {
    const auto lock = locks_.find(lock::lockPath(lookup_.headerOf(interface.name)->path));
    return lock == locks_.end() ? nullptr : lock->second.ofContract(annotation, interface.name);
  }

  const model::Lookup& lookup_;
  const lock::NodeIndexes locks_;
};

/// Puts structs behind those that they hold, and else leaves their order. What holds its own kind
/// is declared before all of them, which is enough where a slot holds it in a block of its own.
class StructSorter {
 public:
  StructSorter(std::vector<model::Struct>& structs, const model::Lookup& lookup)
      : structs_(structs), lookup_(lookup) {
    for (const model::Struct& record : structs) known_.emplace(record.name, &record);
  }

  void sort() {
    for (const model::Struct& record : structs_) place(record.name);
    structs_ = std::move(sorted_);
  }

 private:
  void place(const std::string& name) {
    const auto found = known_.find(name);
    if (found == known_.end() || !seen_.insert(name).second) return;
    for (const model::Field& field : found->second->fields) place(field.type, false);
    sorted_.push_back(*found->second);
  }

  void place(const model::Type& type, bool apart) {
    using Shape = model::Type::Shape;
    const model::Struct* const held = lookup_.findStruct(type.name);
    if (held != nullptr && !(apart && isRecursive(*held, lookup_))) place(type.name);
    const bool sized = type.shape == Shape::List || type.shape == Shape::Map;
    const bool open = sized && type.capacity.value_or(0) == 0;
    for (const model::Type& element : type.element) {
      place(element, apart || open || holdsRecursive(type, lookup_));
    }
  }

  std::vector<model::Struct>& structs_;
  const model::Lookup& lookup_;
  std::unordered_map<std::string, const model::Struct*> known_;
  std::vector<model::Struct> sorted_;
  std::set<std::string> seen_;
};

}  // namespace

model::Model ordered(model::Model model, const lock::Locks& locks) {
  const model::Model declared = model;  // looked up in while the other is sorted
  const model::Lookup lookup(declared);
  const Order order(lookup, locks);
  for (model::Header& header : model.headers) {
    StructSorter(header.structs, lookup).sort();
    for (model::Interface& interface : header.interfaces) order.sort(interface);
  }
  return model;
}

}  // namespace suture::compiler::emit
