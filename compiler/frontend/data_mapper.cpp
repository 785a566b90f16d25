#include "compiler/frontend/data_mapper.h"

#include "compiler/frontend/defaults.h"
#include "compiler/frontend/names.h"
#include "compiler/frontend/scalars.h"

namespace suture::compiler::frontend {
namespace {

std::string fieldSubject(const clang::FieldDecl* field) {
  return "field '" + field->getNameAsString() + "'";
}

model::Enumerator mapEnumerator(const clang::EnumConstantDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (!annotation.unit.empty() || annotation.range || annotation.was || annotation.skip ||
      !annotation.capacity.empty()) {
    mapping.error(declaration, "misplaced-argument", "only name() applies to an enumerator",
                  "drop the other arguments");
  }
  model::Enumerator enumerator;
  enumerator.name = declaration->getNameAsString();
  enumerator.wireName = wireMemberName(enumerator.name, annotation.name);
  enumerator.value = declaration->getInitVal().getExtValue();
  enumerator.doc = mapping.documentationOf(declaration);
  enumerator.source = mapping.sourceOf(declaration);
  return enumerator;
}

/// Whether skip() keeps the field off the wire.
bool isSkipped(const clang::FieldDecl* field, Mapping& mapping) {
  const Annotation annotation = mapping.peek(field, Kind::Field);
  if (!annotation.skip) return false;
  if (annotation.arguments > 1) {
    mapping.error(field, "skip-with-others",
                  fieldSubject(field) + " is skipped, so that nothing else can be said of it",
                  "keep skip(), or the others");
  }
  return true;
}

/// A scalar whose initialiser the lock cannot record.
void checkDefault(const clang::FieldDecl* declaration, const model::Field& field,
                  Mapping& mapping) {
  const bool recorded = field.type.shape == model::Type::Shape::Scalar ||
                        field.type.shape == model::Type::Shape::Enum;
  const clang::Expr* initialiser = declaration->getInClassInitializer();
  if (!recorded || !initialiser || isConstant(initialiser, mapping.context())) return;
  mapping.warn(declaration, "default-not-constant",
               "the initialiser of " + fieldSubject(declaration) +
                   " is no constant; where a sender says nothing, a receiver reads zero",
               "give it a constant");
}

/// Why the field cannot be on the wire, whatever its type. True if an error was reported.
bool rejectField(const clang::FieldDecl* field, Mapping& mapping) {
  const std::string subject = fieldSubject(field);
  if (!field->getIdentifier()) {
    mapping.error(field, "unnamed-field", "an unnamed field has no stable wire name", "name it");
  } else if (field->getAccess() != clang::AS_public) {
    mapping.error(field, "private-field", subject + " is not public",
                  "make it public, or keep it off the wire: SUTURE_FIELD(skip())");
  } else if (field->isBitField()) {
    mapping.error(field, "bit-field", subject + " is a bit-field; its width would be lost",
                  "use a plain integer with range()");
  } else if (field->isMutable()) {
    mapping.error(field, "mutable", subject + " is mutable; it is not part of the value",
                  "keep it off the wire: SUTURE_FIELD(skip())");
  } else {
    return false;
  }
  return true;
}

std::optional<model::Field> mapField(const clang::FieldDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (rejectField(declaration, mapping)) return std::nullopt;
  auto type =
      mapping.typeOf(declaration, declaration->getType(), fieldSubject(declaration), annotation);
  if (!type) return std::nullopt;
  model::Field field;
  field.name = declaration->getNameAsString();
  field.wireName = wireMemberName(field.name, annotation.name);
  field.type = std::move(*type);
  field.unit = annotation.unit;
  field.range = annotation.range;
  field.was = annotation.was;
  field.defaultJson = defaultJsonOf(declaration);
  field.doc = mapping.documentationOf(declaration);
  field.source = mapping.sourceOf(declaration);
  checkDefault(declaration, field, mapping);
  return field;
}

bool isDefaultConstructible(const clang::CXXRecordDecl* declaration) {
  for (const clang::CXXConstructorDecl* constructor : declaration->ctors()) {
    if (constructor->isDefaultConstructor()) {
      return !constructor->isDeleted() && constructor->getAccess() == clang::AS_public;
    }
  }
  return declaration->hasDefaultConstructor();
}

void checkShape(const clang::CXXRecordDecl* declaration, Mapping& mapping) {
  const std::string name = "'" + declaration->getNameAsString() + "'";
  if (declaration->isUnion()) {
    mapping.error(declaration, "union", name + " is a union; it carries no tag",
                  "use a struct with an enum class that says which member counts");
  }
  if (declaration->getNumBases() > 0) {
    mapping.error(declaration, "base-class", name + " has a base class, which is not supported yet",
                  "make the base a member");
  }
  if (!isDefaultConstructible(declaration)) {
    mapping.error(declaration, "no-default-constructor",
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
  result.doc = mapping.documentationOf(declaration);
  result.source = mapping.sourceOf(declaration);
  return result;
}

model::Struct mapStructDeclaration(const clang::CXXRecordDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Type);
  model::Struct result;
  result.name = qualifiedName(declaration);
  result.wireName = wireTypeName(declaration, annotation.name);
  checkShape(declaration, mapping);
  for (const clang::FieldDecl* field : declaration->fields()) {
    if (isSkipped(field, mapping)) continue;
    if (auto mapped = mapField(field, mapping)) result.fields.push_back(std::move(*mapped));
  }
  result.doc = mapping.documentationOf(declaration);
  result.source = mapping.sourceOf(declaration);
  return result;
}

}  // namespace suture::compiler::frontend
