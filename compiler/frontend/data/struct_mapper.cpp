#include "compiler/frontend/data/struct_mapper.h"

#include <algorithm>

#include "compiler/frontend/ast/initialiser.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/data/candidate.h"
#include "compiler/frontend/data/field_mapper.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

bool hasField(const clang::CXXRecordDecl* record, const std::string& name) {
  for (const clang::FieldDecl* field : record->fields()) {
    if (field->getName() == name) return true;
  }
  return false;
}

/// Adds each base class as a field: the first is called `base`, another one `base` with the name of
/// its class.
void addBases(model::Struct& result, const DataDeclaration& declared, Mapping& mapping) {
  const clang::NamedDecl* place = declared.place;
  for (const clang::CXXBaseSpecifier& base : declared.record->bases()) {
    const std::string name =
        base.getType().getCanonicalType()->getAsCXXRecordDecl()->getName().str();
    const std::string subject = "base class '" + name + "'";
    if (base.isVirtual()) {
      mapping.error(place, "virtual-base", subject + " is virtual; its place is not fixed",
                    "make the base a member");
      continue;
    }
    if (base.getAccessSpecifier() != clang::AS_public) {
      mapping.error(place, "private-base", subject + " is not public",
                    "derive publicly, or make it a member");
      continue;
    }
    auto type = mapping.typeOf(place, base.getType(), subject, {});
    if (!type) continue;
    model::Field field;
    field.name = result.fields.empty() ? "base" : "base" + model::titleCase(name);
    field.wireName = field.name;
    if (hasField(declared.record, field.name)) field.name += "_";
    field.type = std::move(*type);
    field.isBase = true;
    field.isPreset = mayBeInitialised(declared.record, base);
    field.source = mapping.sourceOf(place);
    result.fields.push_back(std::move(field));
  }
}

bool isDefaultConstructible(const clang::CXXRecordDecl* declaration) {
  for (const clang::CXXConstructorDecl* constructor : declaration->ctors()) {
    if (constructor->isDefaultConstructor()) {
      return !constructor->isDeleted() && constructor->getAccess() == clang::AS_public;
    }
  }
  return declaration->hasDefaultConstructor();
}

void checkShape(const DataDeclaration& declared, Mapping& mapping) {
  const clang::CXXRecordDecl* declaration = declared.record;
  const clang::NamedDecl* place = declared.place;
  const std::string name = "'" + plainName(declaration) + "'";
  if (declaration->isUnion()) {
    mapping.error(place, "union", name + " is a union; it carries no tag",
                  "use std::variant, or a struct with an enum class that says which member counts");
  }
  const bool all = declared.external && meansAll(*declared.external);
  const auto isPublic = [](const clang::FieldDecl* field) {
    return field->getAccess() == clang::AS_public;
  };
  if (all && !declaration->field_empty() &&
      std::none_of(declaration->field_begin(), declaration->field_end(), isPublic)) {
    mapping.error(place, "external-type", name + " has no public members",
                  "specialise suture::Wire for it, which says what it travels as");
  }
  if (!isDefaultConstructible(declaration)) {
    mapping.error(place, "no-default-constructor",
                  name + " must be default-constructible to be decoded",
                  "add '" + plainName(declaration) + "() = default;'");
  }
}

}  // namespace

model::Struct mapStructDeclaration(const DataDeclaration& declared, Mapping& mapping) {
  model::Struct result;
  result.name = declared.name;
  result.wireName = declared.wireName;
  result.isExternal = declared.external.has_value();
  result.was = declared.was;
  result.lifecycle = declared.lifecycle;
  checkShape(declared, mapping);
  if (!declared.external || meansAll(*declared.external)) addBases(result, declared, mapping);
  for (const Candidate& candidate : candidatesOf(declared, mapping)) {
    auto mapped = mapField(candidate, mapping);
    if (mapped) result.fields.push_back(std::move(*mapped));
  }
  result.doc = mapping.documentationOf(declared.place);
  result.source = mapping.sourceOf(declared.place);
  return result;
}

}  // namespace suture::compiler::frontend
