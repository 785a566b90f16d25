#include "compiler/frontend/types/type_names.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/names.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;

/// Returns the class if it is an instance of a template that is annotated, or an annotated
/// specialisation; null if it is neither.
const Specialisation* annotatedInstance(clang::QualType type) {
  const auto* instance =
      llvm::dyn_cast_or_null<Specialisation>(type.getCanonicalType()->getAsCXXRecordDecl());
  if (!instance) return nullptr;
  const clang::CXXRecordDecl* pattern = instance->getSpecializedTemplate()->getTemplatedDecl();
  const bool annotated = isAnnotated(pattern, Kind::Type) || isAnnotated(instance, Kind::Type);
  return annotated ? instance : nullptr;
}

/// Returns what the user called the type: an alias, or the type itself. Returns null if that is an
/// instance of a template.
const clang::NamedDecl* writtenName(clang::QualType type) {
  if (const auto* alias = type->getAs<clang::TypedefType>()) return alias->getDecl();
  const clang::TagDecl* tag = type->getAsTagDecl();
  return llvm::isa_and_nonnull<Specialisation>(tag) ? nullptr : tag;
}

/// Returns the alias by which SUTURE_EXTERNAL_TYPE names its type.
const clang::TypedefNameDecl* externalAlias(const clang::CXXMethodDecl* members) {
  for (const clang::Decl* one : members->getParent()->decls()) {
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(one)) return alias;
  }
  return nullptr;
}

}  // namespace

std::optional<DataDeclaration> TypeNames::addAlias(const clang::TypedefNameDecl* alias) {
  const clang::DeclContext* scope = alias->getDeclContext()->getRedeclContext();
  if (!scope->isFileContext() || alias->getUnderlyingType()->isDependentType()) return std::nullopt;
  if (!annotatedInstance(alias->getUnderlyingType())) return std::nullopt;
  if (!semantics_.isCompleteType(alias->getLocation(), alias->getUnderlyingType())) {
    return std::nullopt;  // clang has said why
  }
  const auto* instance = annotatedInstance(alias->getUnderlyingType());
  if (!checkVisible(instance, alias)) return std::nullopt;
  DataDeclaration declared{llvm::cast<clang::CXXRecordDecl>(instance->getDefinition()), alias,
                           qualifiedName(alias),
                           wireTypeName(model::Named::Type, alias, std::nullopt), std::nullopt};
  const Annotation pattern =
      mapping_.peek(instance->getSpecializedTemplate()->getTemplatedDecl(), Kind::Type);
  declared.lifecycle = {pattern.since, pattern.deprecated};
  if (!add(declared.record, {declared.name, rootedName(alias), alias}, true)) return std::nullopt;
  return declared;
}

TypeNames::External TypeNames::addExternal(const clang::CXXMethodDecl* members) {
  const clang::TypedefNameDecl* alias = externalAlias(members);
  const clang::QualType type = alias->getUnderlyingType();
  mapping_.addForeign(members, alias->getTypeSourceInfo()->getTypeLoc().getBeginLoc(), nullptr);
  Annotation annotation = mapping_.annotationOf(members, Kind::External);
  const clang::TagDecl* tag = type->getAsTagDecl();
  if (!tag || !semantics_.isCompleteType(members->getLocation(), type)) {
    mapping_.error(members, "external-type",
                   "'" + type.getAsString() + "' is not a class or enum that is defined here",
                   "include the header that defines it");
    return {};
  }
  const clang::NamedDecl* name = writtenName(type);
  if (!name || isAnnotated(tag, Kind::Type)) {
    mapping_.error(
        members, "external-type",
        name ? "'" + plainName(name) + "' is a SUTURE_TYPE itself"
             : "an instance of a template has no name of its own",
        name ? "drop SUTURE_EXTERNAL_TYPE()" : "give it one with 'using', and list that");
    return {};
  }
  if (!checkVisible(tag, members)) return {};
  const std::string known = qualifiedName(name);
  const std::string onWire = wireTypeName(model::Named::Type, name, annotation.name);
  if (!add(tag, {known, rootedName(name), members}, false)) return {};
  if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag)) {
    return DataDeclaration{record->getDefinition(), members, known, onWire, std::move(annotation)};
  }
  auto* enumeration = llvm::cast<clang::EnumDecl>(type->getAsTagDecl());
  // Clang defines an enum within an instance of a template only when it is asked for it.
  if (semantics_.RequireCompleteEnumDecl(enumeration, members->getLocation())) return {};
  return EnumDeclaration{enumeration->getDefinition(), members, known, onWire};
}

bool TypeNames::checkVisible(const clang::TagDecl* type, const clang::NamedDecl* place) {
  if (type->isExternallyVisible()) return true;
  mapping_.error(place, "local-type", "'" + plainName(type) + "' is not visible outside its file",
                 "move it, and what it is made of, into a named namespace");
  return false;
}

bool TypeNames::add(const clang::TagDecl* type, const NamedTypes::Entry& added, bool isAlias) {
  const NamedTypes::Entry& entry = mapping_.names().add(type, added);
  if (entry.declaration == added.declaration) return true;
  if (isAlias && entry.name == added.name) return false;  // it is the same alias again
  const bool again = entry.name == added.name;
  mapping_
      .error(added.declaration, "second-name",
             again ? "'" + added.name + "' is listed already"
                   : "'" + added.name + "' is another name of what is '" + entry.name + "' already",
             again ? "say all of it in one SUTURE_EXTERNAL_TYPE"
                   : "one type has one name on the wire: keep one of the two")
      .notes.push_back({mapping_.sourceOf(entry.declaration), "the first is here"});
  return false;
}

}  // namespace suture::compiler::frontend
