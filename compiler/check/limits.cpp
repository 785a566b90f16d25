#include <algorithm>
#include <set>

#include "compiler/check/rules.h"
#include "compiler/check/type_tree.h"
#include "compiler/model/flat_size.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

constexpr std::uint64_t kLargestValue = 512u << 20;
// Capnp's readers stop at 64; a command's arguments and a row of the state table are two of them.
constexpr unsigned kDeepestValue = 62;

/// How many messages within messages a value needs. Where a type leads back to itself, it is the
/// value that decides.
class Depth {
 public:
  explicit Depth(const model::Lookup& lookup) : lookup_(lookup) {}

  unsigned of(const model::Struct& type) {
    if (!open_.insert(type.name).second) return 0;
    unsigned deepest = 0;
    for (const model::Field& field : type.fields) deepest = std::max(deepest, of(field.type));
    open_.erase(type.name);
    return deepest + 1;
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
  std::set<std::string> open_;
};

/// Whether a value may hold another of its own type; then its bounds do not bound it.
bool leadsBack(const model::Type& type, const model::Lookup& lookup) {
  return !walk(type, lookup, [](const Place& place) { return !place.recursive; });
}

}  // namespace

void checkLimits(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings) {
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) {
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
