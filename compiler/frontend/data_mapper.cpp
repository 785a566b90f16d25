#include "compiler/frontend/data_mapper.h"

#include <clang/AST/DeclFriend.h>

#include "compiler/frontend/ast/defaults.h"
#include "compiler/frontend/ast/initialiser.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/scalars.h"
#include "compiler/frontend/types/type_mapper.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

std::string fieldSubject(const clang::FieldDecl* field) {
  return "field '" + field->getNameAsString() + "'";
}

model::Enumerator mapEnumerator(const clang::EnumConstantDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (!annotation.unit.empty() || annotation.range || !annotation.capacity.empty() ||
      annotation.bulk || annotation.skip) {
    mapping.error(declaration, "misplaced-argument",
                  "only name(), was(), since(), deprecated() and fallback() apply to an enumerator",
                  "drop the other arguments");
  }
  model::Enumerator enumerator;
  enumerator.name = declaration->getNameAsString();
  enumerator.wireName = wireMemberName(enumerator.name, annotation.name);
  enumerator.value = declaration->getInitVal().getExtValue();
  enumerator.fallback = annotation.fallback;
  enumerator.lifecycle = {annotation.since, annotation.deprecated};
  enumerator.was = annotation.was;
  enumerator.doc = mapping.documentationOf(declaration);
  enumerator.source = mapping.sourceOf(declaration);
  return enumerator;
}

/// A data member on its way into the model.
struct Candidate {
  const clang::FieldDecl* field;
  const clang::NamedDecl* place;  ///< where errors are shown: the field, or what lists it
  Annotation annotation;
  bool reachable;  ///< if it is not public

  bool isListed() const { return place != field; }
};

void checkSkipped(const Candidate& candidate, Mapping& mapping) {
  if (candidate.annotation.arguments < 2) return;
  mapping.error(
      candidate.place, "skip-with-others",
      fieldSubject(candidate.field) + " is skipped, so that nothing else can be said of it",
      "keep skip(), or the others");
}

/// Where a sender does not know the member, a receiver must not make up another default for it.
void checkDefault(const Candidate& candidate, Default::State state, Mapping& mapping) {
  const std::string subject = fieldSubject(candidate.field);
  switch (state) {
    case Default::State::Nothing:
    case Default::State::Constant: return;
    case Default::State::NotConstant:
      mapping.error(
          candidate.place, "default-not-constant",
          "the initialiser of " + subject +
              " is no constant that a schema can hold; where a sender does not know it, a "
              "receiver would read zero",
          "give it a constant, or make it a std::optional");
      return;
    case Default::State::NotANumber:
      mapping.error(candidate.place, "default-nan",
                    subject + " is NaN by default, and no contract lets NaN pass",
                    "give it numbers, or make it a std::optional that is empty");
      return;
    case Default::State::TooLong:
      mapping.error(candidate.place, "default-capacity",
                    subject + " is longer by default than its capacity",
                    "give it a shorter default or a larger capacity()");
      return;
    case Default::State::Unseen:
      if (candidate.isListed()) return;
      mapping.error(candidate.place, "default-unseen",
                    "what the default constructor gives " + subject +
                        " cannot be seen here; where a sender does not know it, a receiver may "
                        "read something else",
                    "initialise it where it is declared, or in the list of a constructor without "
                    "statements");
  }
}

/// Reports why a field cannot be on the wire, whatever its type. True if an error was reported.
bool rejectField(const Candidate& candidate, Mapping& mapping) {
  const clang::FieldDecl* field = candidate.field;
  const clang::NamedDecl* place = candidate.place;
  const std::string subject = fieldSubject(field);
  if (!field->getIdentifier() && field->getType()->isUnionType()) {
    mapping.error(place, "union", "an anonymous union carries no tag", "use std::variant");
  } else if (!field->getIdentifier()) {
    mapping.error(place, "unnamed-field", "an unnamed field has no stable wire name", "name it");
  } else if (field->getAccess() != clang::AS_public && !candidate.reachable) {
    mapping.error(place, "private-field", subject + " is not public",
                  "write SUTURE_FRIEND() in the class, or SUTURE_FIELD(skip()) on the field");
  } else if (field->isBitField()) {
    mapping.error(place, "bit-field", subject + " is a bit-field; its width would be lost",
                  "use a plain integer with range()");
  } else if (field->isMutable()) {
    mapping.error(place, "mutable", subject + " is mutable; it is not part of the value",
                  "keep it off the wire: SUTURE_FIELD(skip())");
  } else if (candidate.annotation.fallback) {
    mapping.error(place, "misplaced-argument", "fallback() applies to an enumerator", "drop it");
  } else {
    return false;
  }
  return true;
}

std::optional<model::Field> mapField(const Candidate& candidate, Mapping& mapping) {
  const Annotation& annotation = candidate.annotation;
  const clang::FieldDecl* declaration = candidate.field;
  if (annotation.skip) checkSkipped(candidate, mapping);
  if (annotation.skip || rejectField(candidate, mapping)) return std::nullopt;
  auto type = mapping.typeOf(candidate.place, declaration->getType(), fieldSubject(declaration),
                             annotation);
  if (!type) return std::nullopt;
  model::Field field;
  field.name = declaration->getNameAsString();
  field.wireName = wireMemberName(field.name, annotation.name);
  field.type = std::move(*type);
  field.isHidden = declaration->getAccess() != clang::AS_public;
  field.unit = annotation.unit;
  field.range = annotation.range;
  field.was = annotation.was;
  field.lifecycle = {annotation.since, annotation.deprecated};
  const Default standard = defaultOf(declaration, field.type);
  field.defaultJson = standard.json;
  field.isPreset = isPreset(declaration);
  field.doc = mapping.documentationOf(declaration);
  field.source = mapping.sourceOf(candidate.place);
  checkDefault(candidate, standard.state, mapping);
  return field;
}

/// Has it SUTURE_FRIEND()?
bool hasFriend(const clang::CXXRecordDecl* record) {
  for (const clang::FriendDecl* one : record->friends()) {
    const clang::NamedDecl* name = one->getFriendDecl();
    if (name && qualifiedName(name) == "suture::Members") return true;
  }
  return false;
}

bool hasField(const clang::CXXRecordDecl* record, const std::string& name) {
  for (const clang::FieldDecl* field : record->fields()) {
    if (field->getName() == name) return true;
  }
  return false;
}

/// A base class is a field: the first is `base`, another `base` and its name.
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
  const std::string name = "'" + declaration->getNameAsString() + "'";
  if (declaration->isUnion()) {
    mapping.error(place, "union", name + " is a union; it carries no tag",
                  "use std::variant, or a struct with an enum class that says which member counts");
  }
  if (!isDefaultConstructible(declaration)) {
    mapping.error(place, "no-default-constructor",
                  name + " must be default-constructible to be decoded",
                  "add '" + declaration->getNameAsString() + "() = default;'");
  }
}

}  // namespace

model::Enum mapEnumDeclaration(const clang::EnumDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Type);
  model::Enum result;
  result.name = qualifiedName(declaration);
  result.wireName = wireTypeName(declaration, annotation.name);
  if (!declaration->isScoped()) {
    mapping.error(declaration, "unscoped-enum",
                  "enum '" + declaration->getNameAsString() + "' leaks its enumerators' names",
                  "declare it as enum class");
  }
  const auto* builtin = declaration->getIntegerType()->getAs<clang::BuiltinType>();
  const MappedType underlying =
      builtin ? mapBuiltin(builtin) : TypeProblem{"unsupported-type", "", "use an integer"};
  if (const auto* type = std::get_if<model::Type>(&underlying)) {
    result.underlying = type->scalar;
  } else {
    mapping.error(declaration, std::get<TypeProblem>(underlying).slug,
                  "enum '" + declaration->getNameAsString() + "' has an underlying type that is " +
                      "not portable",
                  "use a fixed-width integer");
  }
  for (const clang::EnumConstantDecl* enumerator : declaration->enumerators()) {
    result.enumerators.push_back(mapEnumerator(enumerator, mapping));
  }
  result.was = annotation.was;
  result.lifecycle = {annotation.since, annotation.deprecated};
  result.doc = mapping.documentationOf(declaration);
  result.source = mapping.sourceOf(declaration);
  return result;
}

model::Struct mapStructDeclaration(const DataDeclaration& declared, Mapping& mapping) {
  model::Struct result;
  result.name = declared.name;
  result.wireName = declared.wireName;
  result.was = declared.was;
  result.lifecycle = declared.lifecycle;
  const std::string home = namespaceOf(declared.record);
  if (home != namespaceOf(declared.place)) result.foreignNamespace = home;
  checkShape(declared, mapping);
  if (declared.listed) {
    for (const ExternalMember& member : *declared.listed) {
      auto mapped = mapField({member.field, declared.place, member.annotation, false}, mapping);
      if (mapped) result.fields.push_back(std::move(*mapped));
    }
  } else {
    addBases(result, declared, mapping);
    const bool reachable = hasFriend(declared.record);
    for (const clang::FieldDecl* field : declared.record->fields()) {
      const Annotation annotation = mapping.annotationOf(field, Kind::Field);
      auto mapped = mapField({field, field, annotation, reachable}, mapping);
      if (mapped) result.fields.push_back(std::move(*mapped));
    }
  }
  result.doc = mapping.documentationOf(declared.place);
  result.source = mapping.sourceOf(declared.place);
  return result;
}

}  // namespace suture::compiler::frontend
