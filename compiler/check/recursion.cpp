#include <set>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

const std::string* structIn(const model::Type& type) {
  if (type.shape == model::Type::Shape::Struct) return &type.name;
  return type.element.empty() ? nullptr : structIn(type.element.front());
}

/// Depth first; `done` holds the structs whose fields lead nowhere back.
class Search {
 public:
  Search(const model::Lookup& lookup, model::Diagnostics& findings)
      : lookup_(lookup), findings_(findings) {}

  void visit(const model::Struct& type) {
    if (done_.contains(type.name)) return;
    open_.insert(type.name);
    for (const model::Field& field : type.fields) {
      const std::string* name = structIn(field.type);
      const model::Struct* next = name ? lookup_.findStruct(*name) : nullptr;
      if (!next) continue;
      if (open_.contains(next->name)) {
        report(field, *next);
      } else {
        visit(*next);
      }
    }
    open_.erase(type.name);
    done_.insert(type.name);
  }

 private:
  void report(const model::Field& field, const model::Struct& type) {
    addError(findings_, field.source, "recursive-type",
             "field '" + field.name + "' leads back to '" + model::unqualified(type.name) +
                 "'; a value would have no bound",
             "keep a flat list of nodes that refer to each other by index")
        .notes.push_back({type.source, "the type is here"});
  }

  const model::Lookup& lookup_;
  model::Diagnostics& findings_;
  std::set<std::string> open_, done_;
};

}  // namespace

void checkRecursion(const model::Model& model, const model::Lookup& lookup,
                    model::Diagnostics& findings) {
  Search search(lookup, findings);
  for (const model::Header& header : model.headers) {
    for (const model::Struct& type : header.structs) search.visit(type);
  }
}

}  // namespace suture::compiler::check
