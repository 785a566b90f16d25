#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "compiler/check/rules.h"
#include "compiler/check/type_tree.h"
#include "compiler/model/flat_size.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

constexpr std::uint64_t kLargestValue = 512u << 20;
// Capnp's readers stop at 64 levels; a command's arguments and a row of the state table are two of
// them.
constexpr unsigned kDeepestValue = 62;

/// Counts how many messages within messages a value needs. It does not follow a type that leads
/// back to itself, because then the value decides.
class Depth {
 public:
  explicit Depth(const model::Lookup& lookup) : lookup_(lookup) {}

  unsigned of(const model::Struct& type) {
    const auto [known, isNew] = depths_.emplace(type.name, 0);
    if (!isNew) return known->second;
    unsigned deepest = 0;
    for (const model::Field& field : type.fields) deepest = std::max(deepest, of(field.type));
    return known->second = deepest + 1;
  }

 private:
  unsigned of(const model::Type& type) {
    if (type.shape == model::Type::Shape::Struct) {
      const model::Struct* const declaration = lookup_.findStruct(type.name);
      return declaration ? of(*declaration) : 0;
    }
    unsigned deepest = 0;
    for (const model::Type& element : type.element) deepest = std::max(deepest, of(element) + 1);
    return deepest;
  }

  const model::Lookup& lookup_;
  std::map<std::string, unsigned> depths_;  // zero for a struct that is being looked into
};

/// Tells if a value may hold another of its own type; then its bounds do not bound it.
bool leadsBack(const model::Type& type, const model::Lookup& lookup) {
  return !walk(type, lookup, [](const Place& place) { return !place.recursive; });
}

/// Tells if the slot of a type would hold one of the struct within itself. It would not by what has
/// no bound, nor by an optional struct that leads back, because those are blocks of their own.
class Within {
 public:
  Within(const model::Struct& target, const model::Lookup& lookup)
      : target_(target.name), lookup_(lookup) {}

  bool of(const model::Type& type) {
    using Shape = model::Type::Shape;
    if (isOpen(type)) return false;
    if (type.shape == Shape::Struct) return ofStruct(type.name);
    const auto held = [this, &type](const model::Type& element) {
      const bool apart = type.shape == Shape::Optional && element.shape == Shape::Struct;
      return !apart && of(element);
    };
    return std::any_of(type.element.begin(), type.element.end(), held);
  }

 private:
  bool ofStruct(const std::string& name) {
    if (name == target_) return true;
    const model::Struct* const type = lookup_.findStruct(name);
    if (type == nullptr || !seen_.insert(name).second) return false;
    return std::any_of(type->fields.begin(), type->fields.end(),
                       [this](const model::Field& field) { return of(field.type); });
  }

  const std::string target_;
  const model::Lookup& lookup_;
  std::set<std::string> seen_;
};

bool hasCapacity(const model::Type& type) {
  return (isSized(type) && !isOpen(type)) ||
         std::any_of(type.element.begin(), type.element.end(), hasCapacity);
}

void checkRecursion(const model::Struct& type, const model::Field& field,
                    const model::Lookup& lookup, model::Diagnostics& findings) {
  if (!hasCapacity(field.type) || !Within(type, lookup).of(field.type)) return;
  addError(findings, field.source, "recursive-capacity",
           "field '" + field.name + "' has a capacity(), and what it holds leads back to '" +
               model::unqualified(type.name) + "'",
           "drop the capacity(), and only devices carry it; for a task, keep a flat list of nodes "
           "that refer to each other by index");
}

}  // namespace

void checkLimits(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings) {
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) {
      checkRecursion(type, field, lookup, findings);
      if (leadsBack(field.type, lookup) || flatSize(field.type, lookup) <= kLargestValue) continue;
      addError(findings, field.source, "value-size",
               "field '" + field.name + "' needs more than " + std::to_string(kLargestValue >> 20) +
                   " MiB at its bounds",
               "no message is as large; lower the bounds, or send it in pieces");
    }
    if (Depth(lookup).of(type) <= kDeepestValue) continue;
    addError(findings, type.source, "nesting",
             "'" + model::unqualified(type.name) + "' is nested more than " +
                 std::to_string(kDeepestValue) + " levels deep",
             "no reader follows that far; flatten it");
  }
}

}  // namespace suture::compiler::check
