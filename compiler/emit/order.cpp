#include "compiler/emit/order.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "compiler/lock/wire_type.h"
#include "compiler/model/lookup.h"

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

/// Where a command or event stands: what a base declares comes first, in the base's own order.
struct Place {
  std::size_t depth;
  unsigned ordinal;

  auto operator<=>(const Place&) const = default;
};

/// The contracts that `interface` derives from, outermost first, and itself.
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
  Order(const model::Lookup& lookup, const lock::Locks& locks) : lookup_(lookup), locks_(locks) {}

  void sort(model::Interface& interface) const {
    sort(interface, interface.commands, "cxx");
    sort(interface, interface.events, "eventsOf");
  }

 private:
  template <class Declarations>
  void sort(const model::Interface& interface, Declarations& declarations,
            const char* annotation) const {
    const auto line = lineage(interface, lookup_);
    const auto place = [&](const auto& one) {
      const std::string& home = one.inheritedFrom.empty() ? interface.name : one.inheritedFrom;
      std::size_t depth = 0;
      while (depth + 1 < line.size() && line[depth]->name != home) ++depth;
      const lock::Node* const node = nodeOf(home, annotation);
      return Place{depth, node == nullptr ? 0 : ordinalOf(*node, one.wireName)};
    };
    std::stable_sort(declarations.begin(), declarations.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
  }

  const lock::Node* nodeOf(const std::string& interface, const char* annotation) const {
    const model::Header* const header = lookup_.headerOf(interface);
    if (header == nullptr) return nullptr;
    const auto lock = locks_.files.find(lock::lockPath(header->path));
    return lock == locks_.files.end() ? nullptr : findNode(lock->second, annotation, interface);
  }

  const model::Lookup& lookup_;
  const lock::Locks& locks_;
};

}  // namespace

model::Model ordered(model::Model model, const lock::Locks& locks) {
  const model::Model declared = model;  // looked up in while the other is sorted
  const model::Lookup lookup(declared);
  const Order order(lookup, locks);
  for (model::Header& header : model.headers) {
    for (model::Interface& interface : header.interfaces) order.sort(interface);
  }
  return model;
}

}  // namespace suture::compiler::emit
